#include "render/culling/triangle_filter.h"

#include "base/thread_pool.h"
#include "gl/buffer_mapping.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "render/instruction_sets.h"

#include <glm/mat3x4.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
/// Meshes of fewer indices are drawn as they are: one command draws many of them.
constexpr std::uint32_t minIndices = 3 * 64;
/// What the filter takes of a frame at most, 4 bytes an index and 16 a vertex; further draws stay as they
/// are.
constexpr std::size_t maxIndices = std::size_t{1} << 25, maxVertices = std::size_t{1} << 23;
constexpr std::uint32_t verticesPerShare = 8192, trianglesPerShare = 4096;
static_assert(verticesPerShare % filterPadding == 0);

/// Rows of the matrix from a mesh to the screen (`ScreenTransform::rows`), and the error of their products.
struct ScreenMatrix {
    float rows[3][4], errors[3];
};

/// The sum over the vertices' box of the absolute terms of a product: what rounding is relative to.
double termsOf(const glm::dvec4& row, const glm::dvec4& reach) {
    return glm::dot(glm::abs(row), reach);
}

ScreenMatrix screenMatrix(std::span<const glm::vec4> worldRows, const BoundingSphere& sphere,
                          const layout::FrameUniforms& frame) {
    // Two products of four terms each, here and on the device, and the rounding of the matrix: 32 times half
    // a unit in the last place of the largest sum of terms bounds all of it.
    constexpr double unit = 32.0 / 16777216.0;
    const glm::dvec4 local(glm::dvec3(glm::abs(sphere.center)) + static_cast<double>(sphere.radius), 1.0);
    glm::dvec4 rows[3], reach(1.0);
    for (int i = 0; i < 3; ++i) {
        rows[i] = glm::dvec4(worldRows[static_cast<std::size_t>(i)]);
        reach[i] = termsOf(rows[i], local);
    }
    const glm::dmat4 clip = glm::transpose(glm::dmat4(frame.clipFromWorld));
    const double width = frame.size.x, height = frame.size.y;
    const glm::dvec4 toScreen[3] = {0.5 * width * (clip[0] + clip[3]), 0.5 * height * (clip[1] + clip[3]),
                                    clip[3]};
    ScreenMatrix matrix;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec4& to = toScreen[k];
        const glm::dvec4 row = to.x * rows[0] + to.y * rows[1] + to.z * rows[2] + glm::dvec4(0, 0, 0, to.w);
        for (int i = 0; i < 4; ++i) matrix.rows[k][i] = static_cast<float>(row[i]);
        // Of x and y too, the device computes w and the coordinate before they are added.
        matrix.errors[k] = static_cast<float>(unit * termsOf(to, reach));
    }
    const double ofW = unit * termsOf(clip[3], reach);
    matrix.errors[0] += static_cast<float>(width * ofW);
    matrix.errors[1] += static_cast<float>(height * ofW);
    return matrix;
}

}  // namespace

extern const TriangleFilterKernel triangleKernelBaseline;
#if defined(__x86_64__)
extern const TriangleFilterKernel triangleKernelAvx2, triangleKernelAvx512;
#endif

std::vector<const TriangleFilterKernel*> triangleFilterKernels() {
    std::vector<const TriangleFilterKernel*> kernels;
#if defined(__x86_64__)
    if (runsAvx512Kernels()) kernels.push_back(&triangleKernelAvx512);
    if (runsAvx2Kernels()) kernels.push_back(&triangleKernelAvx2);
#endif
    kernels.push_back(&triangleKernelBaseline);
    return kernels;
}

TriangleFilter::TriangleFilter(const GpuScene::State& scene, const TriangleFilterKernel& kernel)
    : scene_(scene), kernel_(kernel), firstVertex_(scene.instances.size(), none) {
    scene.describeMeshes(vertexArray_);
}

bool TriangleFilter::isFiltered(const DrawBatch& batch, const DrawCommand& command) const {
    return batch.key.geometry.kind == DrawGeometry::Kind::meshes &&
           batch.key.topology == Topology::triangles && batch.key.furtherUvPairs == 0 &&
           command.count >= minIndices;
}

bool TriangleFilter::hasRoomFor(const DrawCommand& command) const {
    const std::uint32_t instance = scene_.draws.instanceOfRecord(command.baseInstance);
    const MeshPlace& place = scene_.meshes.places()[*scene_.instances[instance].mesh];
    const std::size_t count = command.instanceCount;
    return indexCount_ + count * command.count <= maxIndices &&
           vertexCount_ + count * (place.vertexCount + filterPadding) <= maxVertices;
}

void TriangleFilter::addCommand(const PipelineKey& key, bool filtered, const DrawCommand& command) {
    if (runs_.empty() || runs_.back().filtered != filtered || runs_.back().key != key)
        runs_.push_back({key, filtered, static_cast<std::uint32_t>(commands_.size()), 0});
    commands_.push_back(command);
    ++runs_.back().commandCount;
}

void TriangleFilter::planDraw(const PipelineKey& key, const DrawCommand& command) {
    const std::uint32_t instance = scene_.draws.instanceOfRecord(command.baseInstance);
    const MeshPlace& place = scene_.meshes.places()[*scene_.instances[instance].mesh];
    if (firstVertex_[instance] == none) {
        firstVertex_[instance] = vertexCount_;
        instances_.push_back(instance);
        for (std::uint32_t first = 0; first < place.vertexCount; first += verticesPerShare)
            vertexShares_.push_back({instance, first, std::min(first + verticesPerShare, place.vertexCount)});
        // The kernels write whole vectors: those of two shares, of which threads write one each, do not
        // overlap.
        vertexCount_ += (place.vertexCount + filterPadding - 1) / filterPadding * filterPadding;
    }
    const float facing = key.doubleSided ? 0.0f : key.mirrored ? -1.0f : 1.0f;
    for (std::uint32_t first = 0; first < command.count; first += 3 * trianglesPerShare) {
        TriangleShare share{command, instance, facing, indexCount_};
        share.source.firstIndex += first;
        share.source.count = std::min(command.count - first, 3 * trianglesPerShare);
        DrawCommand planned = command;
        planned.firstIndex = static_cast<std::uint32_t>(triangleShares_.size());
        addCommand(key, true, planned);
        indexCount_ += share.source.count;
        triangleShares_.push_back(share);
    }
}

void TriangleFilter::plan(const DrawSelection& selection) {
    for (const std::uint32_t instance : instances_) firstVertex_[instance] = none;
    instances_.clear();
    vertexShares_.clear();
    triangleShares_.clear();
    commands_.clear();
    runs_.clear();
    vertexCount_ = indexCount_ = 0;
    for (const DrawBatch& batch : selection.batches()) {
        for (const DrawCommand& command : selection.commands(batch)) {
            if (!isFiltered(batch, command) || !hasRoomFor(command)) {
                addCommand(batch.key, false, command);
                continue;
            }
            DrawCommand single = command;
            single.instanceCount = 1;
            for (std::uint32_t i = 0; i < command.instanceCount; ++i, ++single.baseInstance)
                planDraw(batch.key, single);
        }
    }
}

ScreenColumns TriangleFilter::columnsOf(std::uint32_t instance) {
    float* first = columns_.data() + firstVertex_[instance];
    const std::size_t stride = vertexCount_;
    return {first, first + stride, first + 2 * stride, first + 3 * stride};
}

void TriangleFilter::transform(const layout::FrameUniforms& frame) {
    const std::size_t needed = 4 * vertexCount_;
    if (columns_.size() < needed) columns_.resize(needed);
    ThreadPool::shared()->run(vertexShares_.size(), [&](std::size_t i, unsigned) {
        const VertexShare& share = vertexShares_[i];
        const MeshPlace& place = scene_.meshes.places()[*scene_.instances[share.instance].mesh];
        const ScreenMatrix matrix =
            screenMatrix(scene_.instances.record(share.instance), place.sphere, frame);
        ScreenTransform job;
        job.vertices = scene_.meshes.mappedVertices().data() +
                       vertexFloats * (static_cast<std::size_t>(place.baseVertex) + share.first);
        job.count = share.end - share.first;
        std::copy_n(&matrix.rows[0][0], 12, &job.rows[0][0]);
        std::copy_n(matrix.errors, 3, job.errors);
        const ScreenColumns columns = columnsOf(share.instance);
        job.out = {columns.x + share.first, columns.y + share.first, columns.margin + share.first,
                   columns.depth + share.first};
        kernel_.transform(job);
    });
}

void TriangleFilter::filterShares(const layout::FrameUniforms& frame) {
    indexBuffer_.reserve(indexCount_ * sizeof(std::uint32_t));
    const gl::BufferMapping mapping(indexBuffer_, indexCount_ * sizeof(std::uint32_t),
                                    gl::MappingAccess::overwrite);
    const std::span<std::uint32_t> out = mapping.elements<std::uint32_t>(0, indexCount_);
    const bool orthographic = frame.depthRange.w != 0.0f;
    ThreadPool::shared()->run(triangleShares_.size(), [&](std::size_t i, unsigned) {
        TriangleShare& share = triangleShares_[i];
        FilterTriangles job;
        job.vertices = columnsOf(share.instance);
        job.indices = scene_.meshes.mappedIndices().data() + share.source.firstIndex;
        job.count = share.source.count / 3;
        job.width = static_cast<float>(frame.size.x);
        job.height = static_cast<float>(frame.size.y);
        job.nearDepth = orthographic ? -std::numeric_limits<float>::infinity() : frame.eye.w;
        job.facing = share.facing;
        job.out = out.data() + share.out;
        share.kept = kernel_.filter(job);
    });
}

void TriangleFilter::writeCommands() {
    for (const Run& run : runs_) {
        if (!run.filtered) continue;
        for (std::uint32_t i = 0; i < run.commandCount; ++i) {
            DrawCommand& command = commands_[run.firstCommand + i];
            const TriangleShare& share = triangleShares_[command.firstIndex];
            command.firstIndex = static_cast<std::uint32_t>(share.out);
            command.count = share.kept;
        }
    }
    commandBuffer_.upload(std::span<const DrawCommand>(commands_));
    glVertexArrayElementBuffer(vertexArray_.name(), indexBuffer_.name());
}

void TriangleFilter::filter(const DrawSelection& selection, const layout::FrameUniforms& frame) {
    plan(selection);
    if (!triangleShares_.empty()) {
        transform(frame);
        filterShares(frame);
    }
    writeCommands();
}

void TriangleFilter::draw(const Run& run) {
    DrawSelection::draw({run.key, run.firstCommand, run.commandCount});
}

TriangleFilter::Counts TriangleFilter::counts() const {
    Counts counts;
    for (const TriangleShare& share : triangleShares_) {
        counts.asked += share.source.count / 3;
        counts.kept += share.kept / 3;
    }
    return counts;
}

}  // namespace candela
