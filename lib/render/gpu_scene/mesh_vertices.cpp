#include "render/gpu_scene/mesh_vertices.h"

#include "base/runs.h"
#include "base/thread_pool.h"

#include <algorithm>

namespace candela {

void writeSurface(const Mesh& mesh, std::size_t first, std::span<SurfaceVertex> to) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = {mesh.positions[first + i], mesh.normals[first + i]};
}

void writeDetails(const Mesh& mesh, std::size_t first, std::span<DetailVertex> to) {
    for (std::size_t i = 0; i < to.size(); ++i) {
        const std::size_t from = first + i;
        DetailVertex vertex;
        if (!mesh.tangents.empty()) vertex.tangent = mesh.tangents[from];
        if (!mesh.uv0.empty()) vertex.uv0 = mesh.uv0[from];
        if (!mesh.uv1.empty()) vertex.uv1 = mesh.uv1[from];
        if (!mesh.colors.empty()) vertex.color = mesh.colors[from];
        to[i] = vertex;
    }
}

void writeFurtherUvs(const Mesh& mesh, std::size_t first, std::size_t pairs, std::span<glm::vec2> to) {
    const std::size_t stride = 2 * pairs, vertices = to.size() / stride;
    for (std::size_t i = 0; i < vertices; ++i) {
        for (std::size_t set = 0; set < stride; ++set) {
            const bool isThere = set < mesh.furtherUvs.size() && !mesh.furtherUvs[set].empty();
            to[i * stride + set] = isThere ? mesh.furtherUvs[set][first + i] : glm::vec2(0.0f);
        }
    }
}

void writeIndices(const Mesh& mesh, std::size_t first, std::span<std::uint32_t> to) {
    std::copy_n(mesh.indices.data() + first, to.size(), to.data());
}

void MeshElements::append(std::uint32_t mesh, std::size_t count) {
    for (std::size_t first = 0; first < count; first += runLength)
        runs_.push_back({mesh, first, count_ + first, std::min(runLength, count - first)});
    count_ += count;
}

void MeshElements::visit(std::size_t first, std::size_t end,
                         const std::function<void(const Run&)>& visit) const {
    const auto from = std::ranges::partition_point(
        runs_, [first](const Run& run) { return run.first + run.count <= first; });
    const auto to =
        std::partition_point(from, runs_.end(), [end](const Run& run) { return run.first < end; });
    ThreadPool::shared()->run(static_cast<std::size_t>(to - from), [&](std::size_t i, unsigned) {
        Run run = from[static_cast<std::ptrdiff_t>(i)];
        const std::size_t skipped = std::max(run.first, first) - run.first;
        run.count = std::min(run.first + run.count, end) - run.first - skipped;
        run.first += skipped;
        run.firstOfMesh += skipped;
        visit(run);
    });
}

}  // namespace candela
