#include "render/culling/compute_triangle_filter.h"

#include "base/thread_pool.h"
#include "render/gpu_scene/gpu_scene_state.h"

#include <algorithm>
#include <bit>

namespace candela {

namespace {

/// Of a frame, 4 bytes each on the device, whether they are kept or not; further draws stay as they are.
constexpr std::size_t maxFrameIndices = std::size_t{1} << 26;

std::size_t maxStorageBlock() {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return static_cast<std::size_t>(bytes);
}

std::uint32_t blocksOf(std::uint32_t groups) {
    return (groups + layout::BLOCK_CLUSTERS - 1) / layout::BLOCK_CLUSTERS;
}

}  // namespace

ComputeTriangleFilter::ComputeTriangleFilter(const GpuScene::State& scene, std::uint32_t minDrawTriangles)
    : TriangleFilter(scene), minIndices_(3 * minDrawTriangles), maxBlock_(maxStorageBlock()) {}

/// Buffers may have grown since the last frame.
bool ComputeTriangleFilter::readsMeshes() const {
    return std::max({scene_.meshes.surface().capacity(), scene_.meshes.indices().capacity(),
                     scene_.clusters.clusters().size_bytes()}) <= maxBlock_;
}

void ComputeTriangleFilter::uploadClusters() {
    if (clusterVersion_ == scene_.clusters.version()) return;
    clusterVersion_ = scene_.clusters.version();
    clusterBuffer_.upload(scene_.clusters.clusters());
}

void ComputeTriangleFilter::uploadDraws(const layout::FrameUniforms& frame) {
    records_.resize(draws_.size());
    groups_ = 0;
    for (std::size_t i = 0; i < draws_.size(); ++i) {
        const Draw& draw = draws_[i];
        layout::FilterDraw& record = records_[i];
        record.firstCluster = draw.clusters.first;
        record.firstGroup = groups_;
        record.groupEnd = groups_ += draw.clusters.count;
        record.firstIndex = draw.source.firstIndex;
        record.indexCount = draw.source.count;
        record.baseVertex = draw.source.baseVertex;
        record.command = static_cast<std::uint32_t>(draw.command);
        record.reserved = 0;
    }
    const FilterCamera camera(frame);
    ThreadPool::shared()->run(draws_.size(),
                              [&](std::size_t i, unsigned) { records_[i].view = viewOf(draws_[i], camera); });
    drawBuffer_.upload(std::span<const layout::FilterDraw>(records_));
}

void ComputeTriangleFilter::bindStorage() const {
    const auto bind = [](int binding, const gl::Buffer& buffer) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), buffer.name());
    };
    bind(layout::FILTER_DRAWS_STORAGE, drawBuffer_);
    bind(layout::FILTER_INDICES_STORAGE, scene_.meshes.indices());
    bind(layout::FILTER_RESULTS_STORAGE, resultBuffer_);
    bind(layout::FILTER_SUMS_STORAGE, sumBuffer_);
    bind(layout::FILTER_CLUSTERS_STORAGE, clusterBuffer_);
    bind(layout::FILTER_VERTICES_STORAGE, scene_.meshes.surface());
    bind(layout::FILTER_OUTPUT_STORAGE, indexBuffer_);
    bind(layout::FILTER_COMMANDS_STORAGE, commandBuffer_);
}

void ComputeTriangleFilter::dispatch() {
    if (!programs_) {
        programs_.emplace(
            Programs{gl::Program({{"triangle_filter_cull.comp", {}, {}}}, "triangle filter"),
                     gl::Program({{"triangle_filter_blocks.comp", {}, {}}}, "triangle filter sums of blocks"),
                     gl::Program({{"triangle_filter_total.comp", {}, {}}}, "triangle filter sums"),
                     gl::Program({{"triangle_filter_write.comp", {}, {}}}, "triangle filter indices")});
    }
    const auto run = [&](const gl::Program& program, std::uint32_t columns, std::uint32_t rows) {
        glUseProgram(program.name());
        glUniform2i(layout::FILTER_COUNTS_LOCATION, static_cast<GLint>(draws_.size()),
                    static_cast<GLint>(groups_));
        glDispatchCompute(columns, rows, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    };
    const std::uint32_t columns = std::min(groups_, layout::GROUPS_PER_ROW),
                        rows = (groups_ + layout::GROUPS_PER_ROW - 1) / layout::GROUPS_PER_ROW;
    run(programs_->cull, columns, rows);
    run(programs_->sumBlocks, blocksOf(groups_), 1);
    run(programs_->sumAll, 1, 1);
    run(programs_->write, columns, rows);
    // The next frame's commands are uploaded to where shaders have written.
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void ComputeTriangleFilter::filter(const DrawSelection& selection, const layout::FrameUniforms& frame) {
    const std::size_t maxIndices = std::min(maxFrameIndices, maxBlock_ / sizeof(std::uint32_t));
    plan(selection, {minIndices_, readsMeshes() ? maxIndices : 0, SurfaceSet::opaque});
    commandBuffer_.upload(std::span<const DrawCommand>(commands_));
    groups_ = 0;
    if (draws_.empty()) return;
    uploadClusters();
    uploadDraws(frame);
    std::size_t indices = 0;
    for (const Draw& draw : draws_) indices += draw.source.count;
    indexBuffer_.reserve(indices * sizeof(std::uint32_t));
    resultBuffer_.reserve(groups_ * sizeof(layout::ClusterResult));
    sumBuffer_.reserve((blocksOf(groups_) + 1) * sizeof(std::uint32_t));
    bindStorage();
    dispatch();
    glVertexArrayElementBuffer(vertexArray_.name(), indexBuffer_.name());
}

TriangleFilter::Counts ComputeTriangleFilter::counts() const {
    Counts counts;
    if (groups_ == 0) return counts;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    const auto results = resultBuffer_.read<layout::ClusterResult>(0, groups_);
    for (const layout::FilterDraw& record : records_) {
        counts.asked += record.indexCount / 3;
        for (std::uint32_t group = record.firstGroup; group < record.groupEnd; ++group) {
            const std::uint32_t before = (group - record.firstGroup) * layout::CLUSTER_TRIANGLES;
            const layout::ClusterResult& result = results[group];
            if (result.tested != 0)
                counts.inKeptClusters +=
                    std::min<std::uint32_t>(record.indexCount / 3 - before, layout::CLUSTER_TRIANGLES);
            counts.kept +=
                static_cast<std::size_t>(std::popcount(result.kept[0]) + std::popcount(result.kept[1]));
        }
    }
    return counts;
}

}  // namespace candela
