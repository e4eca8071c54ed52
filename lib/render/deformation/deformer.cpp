#include "render/deformation/deformer.h"

#include "base/thread_pool.h"
#include "gl/buffer_mapping.h"
#include "render/instruction_sets.h"
#include "render/layout.h"

#include <candela/error.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>

namespace candela {

namespace {

void bindStorage(int binding, const gl::Buffer& buffer) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), buffer.name());
}

/// From this size on vertices are written past the caches: what draws read next is not in them any more.
constexpr std::size_t minStreamedBytes = std::size_t{8} << 20;

bool isAligned(const float* memory) {
    return reinterpret_cast<std::uintptr_t>(memory) % 16 == 0;
}

/// Consecutive blocks of one job, for one thread.
struct Share {
    std::size_t job;
    std::uint32_t first, end;
};

std::vector<Share> sharesOf(std::span<const DeformRequest> requests) {
    constexpr std::uint32_t blocksPerShare = 32;
    std::vector<Share> shares;
    for (std::size_t i = 0; i < requests.size(); ++i) {
        const std::uint32_t blocks = requests[i].mesh.blockCount();
        for (std::uint32_t first = 0; first < blocks; first += blocksPerShare)
            shares.push_back({i, first, std::min(first + blocksPerShare, blocks)});
    }
    return shares;
}

}  // namespace

extern const DeformKernel deformKernelBaseline;
#if defined(__x86_64__)
extern const DeformKernel deformKernelAvx2;
#endif

std::vector<const DeformKernel*> deformKernels() {
    std::vector<const DeformKernel*> kernels;
#if defined(__x86_64__)
    // Wider vectors gain nothing: blending has as many loads with them.
    if (widestInstructionSet() >= InstructionSet::avx2) kernels.push_back(&deformKernelAvx2);
#endif
    kernels.push_back(&deformKernelBaseline);
    return kernels;
}

void CpuDeformer::deform(std::span<const DeformRequest> requests) {
    std::vector<std::unique_ptr<gl::BufferMapping>> mappings;
    std::vector<DeformJob> jobs;
    const auto map = [&](const gl::Buffer& buffer, std::size_t bytes) {
        return mappings
            .emplace_back(std::make_unique<gl::BufferMapping>(buffer, bytes, gl::MappingAccess::overwrite))
            ->floats();
    };
    std::size_t total = 0;
    for (const DeformRequest& request : requests) total += request.mesh.surfaceBytes();
    for (const DeformRequest& request : requests) {
        DeformJob& job = jobs.emplace_back(request.mesh.job());
        if (request.joints != nullptr) {
            job.joints = request.joints->rows.data();
            job.directionScale = request.joints->directionScale;
        }
        if (!request.morphWeights.empty()) job.morphWeights = request.morphWeights.data();
        job.surface = map(request.buffers.surface, request.mesh.surfaceBytes());
        job.streams = total >= minStreamedBytes && isAligned(job.surface);
        if (request.mesh.hasTangents())
            job.tangents = map(request.buffers.tangents, request.mesh.tangentBytes());
    }
    const std::vector<Share> shares = sharesOf(requests);
    static const DeformKernel& kernel = *deformKernels().front();
    ThreadPool::shared()->run(shares.size(), [&](std::size_t i, unsigned) {
        kernel.deform(jobs[shares[i].job], shares[i].first, shares[i].end);
    });
}

ComputeDeformer::ComputeDeformer() : program_({{"deform.comp", {}, {}}}, "deform") {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    maxBlock_ = static_cast<std::size_t>(bytes);
}

bool ComputeDeformer::supports(const DeformRequest& request) const {
    const std::size_t joints = request.joints != nullptr ? request.joints->rows.size() : 0;
    const std::size_t pose = (joints + request.morphWeights.size()) * sizeof(float);
    return std::max(request.mesh.largestBuffer(), pose) <= maxBlock_;
}

void ComputeDeformer::deform(std::span<const DeformRequest> requests) {
    glUseProgram(program_.name());
    const auto sizeOf = [](const DeformRequest& request) {
        return (request.joints != nullptr ? request.joints->rows.size() : 0) + request.morphWeights.size();
    };
    for (std::size_t next = 0; next < requests.size();) {
        // As many requests as one storage block holds the poses of.
        const std::size_t first = next;
        poses_.clear();
        do {
            const DeformRequest& request = requests[next];
            if (request.joints != nullptr)
                poses_.insert(poses_.end(), request.joints->rows.begin(), request.joints->rows.end());
            poses_.insert(poses_.end(), request.morphWeights.begin(), request.morphWeights.end());
            ++next;
        } while (next < requests.size() &&
                 (poses_.size() + sizeOf(requests[next])) * sizeof(float) <= maxBlock_);
        poseBuffer_.upload(std::span<const float>(poses_));
        bindStorage(layout::DEFORM_POSES_STORAGE, poseBuffer_);
        std::size_t pose = 0;
        for (const DeformRequest& request : requests.subspan(first, next - first)) {
            dispatch(request, pose);
            pose += sizeOf(request);
        }
    }
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
}

void ComputeDeformer::dispatch(const DeformRequest& request, std::size_t firstPose) const {
    constexpr std::uint32_t maxGroups = 65535;  // The minimum that OpenGL guarantees along one axis.
    MeshDeformation& mesh = request.mesh;
    const MeshDeformation::Storage& storage = mesh.storage();
    bindStorage(layout::DEFORM_REST_STORAGE, storage.rest);
    bindStorage(layout::DEFORM_RUNS_STORAGE, storage.runs);
    bindStorage(layout::DEFORM_INFLUENCES_STORAGE, storage.influences);
    bindStorage(layout::DEFORM_ROWS_STORAGE, storage.rows);
    bindStorage(layout::DEFORM_ENTRIES_STORAGE, storage.entries);
    bindStorage(layout::DEFORM_SURFACE_STORAGE, request.buffers.surface);
    if (mesh.hasTangents()) bindStorage(layout::DEFORM_TANGENTS_STORAGE, request.buffers.tangents);
    const std::size_t joints = request.joints != nullptr ? request.joints->rows.size() : 0;
    glUniform4ui(layout::DEFORM_POSE_LOCATION, mesh.vertexCount(),
                 joints > 0 ? static_cast<GLuint>(firstPose) : layout::DEFORM_NONE,
                 request.morphWeights.empty() ? layout::DEFORM_NONE : static_cast<GLuint>(firstPose + joints),
                 mesh.hasTangents() ? 1 : 0);
    glUniform1f(layout::DEFORM_SCALE_LOCATION,
                request.joints != nullptr ? request.joints->directionScale : 1.0f);
    const std::uint32_t groups = mesh.blockCount(), columns = std::min(groups, maxGroups);
    glDispatchCompute(columns, (groups + columns - 1) / columns, 1);
}

Deformer::Deformer(const Context& context, VertexEvaluator evaluator) : evaluator_(evaluator) {
    if (evaluator_ == VertexEvaluator::automatic)
        evaluator_ = context.isSoftware() ? VertexEvaluator::cpu : VertexEvaluator::compute;
}

void Deformer::deform(std::span<const DeformRequest> requests) {
    onDevice_.clear();
    onCpu_.clear();
    for (const DeformRequest& request : requests) {
        if (request.mesh.vertexCount() == 0) continue;
        if (evaluator_ == VertexEvaluator::compute && !compute_) compute_.emplace();
        const bool onDevice = evaluator_ == VertexEvaluator::compute && compute_->supports(request);
        (onDevice ? onDevice_ : onCpu_).push_back(request);
    }
    if (!onDevice_.empty()) compute_->deform(onDevice_);
    if (!onCpu_.empty()) CpuDeformer::deform(onCpu_);
    if (!onDevice_.empty() || !onCpu_.empty())
        lastUsed_ = onDevice_.empty() ? VertexEvaluator::cpu : VertexEvaluator::compute;
}

}  // namespace candela
