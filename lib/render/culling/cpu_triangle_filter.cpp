#include "render/culling/cpu_triangle_filter.h"

#include "base/thread_pool.h"
#include "gl/buffer_mapping.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "render/instruction_sets.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <memory>

namespace candela {

namespace {

/// Clusters of a share: a bit each.
constexpr std::uint32_t clustersPerShare = 32;
/// Further draws stay as they are. Memory is taken for the indices that are kept, 8 bytes each.
constexpr std::size_t maxIndices = std::size_t{1} << 28;

}  // namespace

extern const TriangleFilterKernel triangleKernelBaseline;
#if defined(__x86_64__)
extern const TriangleFilterKernel triangleKernelAvx2, triangleKernelAvx512;
#endif

std::vector<const TriangleFilterKernel*> triangleFilterKernels() {
    std::vector<const TriangleFilterKernel*> kernels;
#if defined(__x86_64__)
    if (widestInstructionSet() >= InstructionSet::avx512) kernels.push_back(&triangleKernelAvx512);
    if (widestInstructionSet() >= InstructionSet::avx2) kernels.push_back(&triangleKernelAvx2);
#endif
    kernels.push_back(&triangleKernelBaseline);
    return kernels;
}

CpuTriangleFilter::CpuTriangleFilter(const GpuScene::State& scene, const TriangleFilterKernel& kernel)
    : TriangleFilter(scene), kernel_(kernel) {}

void CpuTriangleFilter::planShares() {
    constexpr std::uint32_t clusterIndices = 3 * layout::CLUSTER_TRIANGLES;
    shares_.clear();
    for (std::size_t i = 0; i < draws_.size(); ++i) {
        const Draw& draw = draws_[i];
        for (std::uint32_t first = 0; first < draw.clusters.count; first += clustersPerShare) {
            Share share{i, {draw.clusters.first + first, 0}, first * clusterIndices, 0};
            share.clusters.count = std::min(draw.clusters.count - first, clustersPerShare);
            share.indexCount =
                std::min(draw.source.count - share.firstIndex, share.clusters.count * clusterIndices);
            share.firstIndex += draw.source.firstIndex;
            shares_.push_back(share);
        }
    }
}

void CpuTriangleFilter::filterShare(Share& share, unsigned worker, const FilterCamera& camera) {
    const layout::FilterView view = viewOf(draws_[share.draw], camera);
    Kept& kept = kept_[worker];
    share.worker = worker;
    share.place = kept.count;
    if (kept.indices.size() < kept.count + share.indexCount)
        kept.indices.resize(kept.count + kept.count / 2 + share.indexCount);
    filterClusters(share, view, kept.indices.data() + kept.count);
    kept.count += share.kept;
}

void CpuTriangleFilter::filterClusters(Share& share, const layout::FilterView& view,
                                       std::uint32_t* out) const {
    constexpr std::uint32_t clusterIndices = 3 * layout::CLUSTER_TRIANGLES;
    const Draw& draw = draws_[share.draw];
    FilterTriangles job{};
    job.view = &view;
    job.vertices = scene_.meshes.mappedVertices().data() +
                   static_cast<std::ptrdiff_t>(draw.source.baseVertex) * vertexFloats;
    std::uint64_t kept =
        kernel_.cull({&view, scene_.clusters.clusters().data() + share.clusters.first, share.clusters.count});
    while (kept != 0) {
        // Neighbours are filtered together.
        const auto first = static_cast<std::uint32_t>(std::countr_zero(kept));
        const auto count = static_cast<std::uint32_t>(std::countr_one(kept >> first));
        kept &= ~(((std::uint64_t{1} << count) - 1) << first);
        const std::uint32_t end = std::min((first + count) * clusterIndices, share.indexCount);
        const IndexRange indices{first * clusterIndices, end - first * clusterIndices};
        share.inKeptClusters += indices.count;
        filterVisible(share, job, indices, out);
    }
}

/// Filters indices of the share, but for triangles that others hide.
void CpuTriangleFilter::filterVisible(Share& share, FilterTriangles& job, const IndexRange& indices,
                                      std::uint32_t* out) const {
    const std::uint32_t instance = draws_[share.draw].instance;
    const std::uint32_t base =
        share.firstIndex - scene_.meshes.places()[*scene_.instances[instance].mesh].firstIndex;
    std::uint32_t first = indices.first;
    const std::uint32_t end = first + indices.count;
    // Triangles of a mesh are counted in threes of its indices; a draw that starts between them has none
    // hidden.
    if (base % 3 == 0) {
        const HiddenTriangle beyond{instance, (base + end) / 3};
        auto hidden = std::ranges::lower_bound(hidden_, HiddenTriangle{instance, (base + first) / 3});
        for (; hidden != hidden_.end() && *hidden < beyond; ++hidden) {
            const std::uint32_t at = 3 * hidden->triangle - base;
            filterRun(share, job, {first, at - first}, out);
            first = at + 3;
        }
    }
    filterRun(share, job, {first, end - first}, out);
}

void CpuTriangleFilter::filterRun(Share& share, FilterTriangles& job, const IndexRange& indices,
                                  std::uint32_t* out) const {
    if (indices.count == 0) return;
    job.indices = scene_.meshes.mappedIndices().data() + share.firstIndex + indices.first;
    job.count = indices.count / 3;
    job.out = out + share.kept;
    share.kept += kernel_.filter(job);
}

/// Copies what the threads have kept to the device, in the order of the draws.
void CpuTriangleFilter::gather() {
    std::size_t count = 0;
    for (Share& share : shares_) {
        share.out = count;
        count += share.kept;
    }
    if (count == 0) return;
    indexBuffer_.reserve(count * sizeof(std::uint32_t));
    const gl::BufferMapping mapping(indexBuffer_, count * sizeof(std::uint32_t),
                                    gl::MappingAccess::overwrite);
    const std::span<std::uint32_t> out = mapping.elements<std::uint32_t>(0, count);
    ThreadPool::shared()->run(shares_.size(), [&](std::size_t i, unsigned) {
        const Share& share = shares_[i];
        std::copy_n(kept_[share.worker].indices.data() + share.place, share.kept, out.data() + share.out);
    });
}

void CpuTriangleFilter::writeCommands() {
    for (const Draw& draw : draws_) commands_[draw.command].count = 0;
    for (const Share& share : shares_) {
        DrawCommand& command = commands_[draws_[share.draw].command];
        if (command.count == 0) command.firstIndex = static_cast<std::uint32_t>(share.out);
        command.count += share.kept;
    }
    commandBuffer_.upload(std::span<const DrawCommand>(commands_));
    glVertexArrayElementBuffer(vertexArray_.name(), indexBuffer_.name());
}

void CpuTriangleFilter::filter(const DrawSelection& selection, const layout::FrameUniforms& frame) {
    plan(selection, {MeshClusters::minIndices, maxIndices, SurfaceSet::all});
    planShares();
    hidden_ = selection.hiddenTriangles();
    const FilterCamera camera(frame);
    const std::shared_ptr<ThreadPool> pool = ThreadPool::shared();
    kept_.resize(pool->size());
    for (Kept& kept : kept_) kept.count = 0;
    pool->run(shares_.size(),
              [&](std::size_t i, unsigned worker) { filterShare(shares_[i], worker, camera); });
    gather();
    writeCommands();
}

TriangleFilter::Counts CpuTriangleFilter::counts() const {
    Counts counts;
    for (const Share& share : shares_) {
        counts.asked += share.indexCount / 3;
        counts.inKeptClusters += share.inKeptClusters / 3;
        counts.kept += share.kept / 3;
    }
    return counts;
}

}  // namespace candela
