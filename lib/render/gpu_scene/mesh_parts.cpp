#include "render/gpu_scene/draw_list.h"
#include "scene/geometry/topology.h"

#include <algorithm>

namespace candela {

namespace {

std::span<const Submesh> submeshesOf(const Mesh& mesh, const Submesh& whole) {
    return mesh.submeshes.empty() ? std::span(&whole, 1) : std::span(mesh.submeshes);
}

Submesh wholeOf(const Mesh& mesh) {
    return {0, static_cast<std::uint32_t>(mesh.indices.size()), std::nullopt};
}

}  // namespace

MeshParts partsOf(const Mesh& mesh) {
    const Submesh whole = wholeOf(mesh);
    MeshParts result;
    for (const Submesh& submesh : submeshesOf(mesh, whole)) {
        if (submesh.indexCount == 0) continue;
        result.parts.push_back({{submesh.firstIndex, submesh.indexCount},
                                submesh.material,
                                submesh.topology,
                                isUnlit(mesh, submesh)});
    }
    result.hasColors = !mesh.colors.empty();
    result.hasFurtherUvs = !mesh.furtherUvs.empty();
    result.uvs = uvSetsOf(mesh);
    if (!mesh.joints.empty()) result.jointCount = *std::ranges::max_element(mesh.joints) + 1;
    result.morphTargetCount = static_cast<std::uint32_t>(mesh.morphTargets.size());
    return result;
}

std::uint64_t MeshParts::elements(Topology topology) const {
    std::uint64_t count = 0;
    for (const Part& part : parts) {
        if (part.topology == topology) count += part.indices.count / cornersOf(topology);
    }
    return count;
}

}  // namespace candela
