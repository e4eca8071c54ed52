#include "scene/geometry/vertex_copy.h"

#include "base/error_context.h"

#include <limits>

namespace candela {

namespace {

template <typename Value>
void duplicate(std::vector<Value>& values, std::uint32_t vertex) {
    if (!values.empty()) values.push_back(Value(values[vertex]));
}

}  // namespace

std::uint32_t appendVertexCopy(Mesh& mesh, std::uint32_t vertex) {
    if (mesh.positions.size() >= std::numeric_limits<std::uint32_t>::max()) {
        ErrorContext("mesh", {}, mesh.name)
            .refuse("has more vertices than 32 bits can count once normals or tangents have split them",
                    ErrorKind::limit);
    }
    duplicate(mesh.positions, vertex);
    duplicate(mesh.normals, vertex);
    duplicate(mesh.tangents, vertex);
    duplicate(mesh.uv0, vertex);
    duplicate(mesh.uv1, vertex);
    for (auto& uvs : mesh.furtherUvs) duplicate(uvs, vertex);
    duplicate(mesh.colors, vertex);
    for (std::uint32_t i = 0; i < mesh.influenceCount; ++i) {
        const std::size_t influence = std::size_t{vertex} * mesh.influenceCount + i;
        mesh.joints.push_back(std::uint32_t{mesh.joints[influence]});
        mesh.jointWeights.push_back(float{mesh.jointWeights[influence]});
    }
    for (MorphTarget& target : mesh.morphTargets) {
        duplicate(target.offsets, vertex);
        duplicate(target.normalOffsets, vertex);
        duplicate(target.tangentOffsets, vertex);
    }
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

}  // namespace candela
