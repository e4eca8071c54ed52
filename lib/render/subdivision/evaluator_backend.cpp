#include "render/subdivision/evaluator_backend.h"

#include "base/thread_pool.h"
#include "gl/buffer_mapping.h"
#include "render/layout.h"
#include "scene/geometry/axes.h"
#include "scene/geometry/limit_evaluation.h"

#include <candela/error.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <string>

namespace candela {

namespace {

void bindStorage(int binding, const gl::Buffer& buffer) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), buffer.name());
}

std::size_t maxStorageBlock() {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return static_cast<std::size_t>(bytes);
}

}  // namespace

glm::vec4 limitTangent(const glm::vec3& normal, const glm::vec3& du, const glm::vec3& dv,
                       const glm::vec4& uv) {
    // The chain rule for du and dv, solved for the derivative along u; of its divisor only the sign matters.
    const glm::dvec3 axis(normal);
    const double area = double{uv.x} * uv.w - double{uv.y} * uv.z;
    const glm::dvec3 alongU =
        (glm::dvec3(du) * double{uv.w} - glm::dvec3(dv) * double{uv.y}) * (area < 0.0 ? -1.0 : 1.0);
    const glm::dvec3 inPlane = alongU - axis * glm::dot(axis, alongU);
    const double length = glm::length(inPlane);
    if (area == 0.0 || !(length > 0.0)) return {glm::vec3(anyPerpendicular(axis)), 1.0f};
    return {glm::vec3(inPlane / length), area < 0.0 ? 1.0f : -1.0f};
}

ComputeEvaluator::ComputeEvaluator()
    : program_({{"cage_limit.comp", {}, {}}}, "cage limit"), maxBlock_(maxStorageBlock()) {}

bool ComputeEvaluator::supports(const EvaluationRequest& request) const {
    const RefinedCage& refined = request.table.refined();
    const std::size_t largest =
        std::max({refined.positions.controlIndices.size() * GpuStencilTable::Storage::entryBytes,
                  LimitBuffers::surfaceBytes(refined.vertexCount()), request.uvDerivatives.size_bytes(),
                  request.points.size_bytes()});
    // llvmpipe silently ends a loop after 65,535 iterations.
    constexpr std::uint32_t maxSupportedSize = 65535;
    return largest <= maxBlock_ && request.table.maxStencilSize() <= maxSupportedSize;
}

void ComputeEvaluator::evaluate(const EvaluationRequest& request) const {
    const RefinedCage& refined = request.table.refined();
    if (refined.vertexCount() == 0) return;
    const GpuStencilTable::Storage& storage = request.table.storage();
    const bool needsTangents = !request.uvDerivatives.empty();
    bindStorage(layout::LIMIT_OFFSETS_STORAGE, storage.offsets);
    bindStorage(layout::LIMIT_ENTRIES_STORAGE, storage.entries);
    bindStorage(layout::LIMIT_POINTS_STORAGE, request.pointBuffer);
    bindStorage(layout::LIMIT_SURFACE_STORAGE, request.buffers.surface);
    if (needsTangents) {
        bindStorage(layout::LIMIT_UVS_STORAGE, request.table.uvDerivativeBuffer());
        bindStorage(layout::LIMIT_TANGENTS_STORAGE, request.buffers.tangents);
    }
    glUseProgram(program_.name());
    glUniform1i(layout::LIMIT_TANGENTS_LOCATION, needsTangents ? 1 : 0);
    dispatch(0, refined.pointCount, request.table);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    dispatch(refined.pointCount, refined.vertexCount(), request.table);
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
}

void ComputeEvaluator::dispatch(std::size_t first, std::size_t end, const GpuStencilTable& table) const {
    if (first == end) return;
    constexpr std::size_t groupSize = 64;
    constexpr std::size_t maxGroups = 65535;  // The minimum that OpenGL guarantees along one axis.
    const RefinedCage& refined = table.refined();
    const std::size_t groups = (end - first + groupSize - 1) / groupSize;
    const std::size_t columns = std::min(groups, maxGroups);
    glUniform4ui(layout::LIMIT_RANGE_LOCATION, static_cast<GLuint>(first), static_cast<GLuint>(end),
                 refined.pointCount, static_cast<GLuint>(refined.vertexCount()));
    glDispatchCompute(static_cast<GLuint>(columns), static_cast<GLuint>((groups + columns - 1) / columns), 1);
}

void CpuEvaluator::evaluate(const EvaluationRequest& request) {
    const RefinedCage& refined = request.table.refined();
    const std::size_t vertices = refined.vertexCount();
    if (vertices == 0) return;
    // Read as well: seam vertices copy the positions written for their points.
    const gl::BufferMapping surface(request.buffers.surface, LimitBuffers::surfaceBytes(vertices),
                                    gl::MappingAccess::readWrite);
    LimitVertices out{
        surface.elements<glm::vec3>(0, vertices), surface.elements<glm::vec3>(vertices, vertices), {}, {}};
    const bool needsTangents = !request.uvDerivatives.empty();
    if (needsTangents) {
        du_.resize(vertices);
        dv_.resize(vertices);
        out.du = du_;
        out.dv = dv_;
    }
    evaluateValidatedLimit(refined, request.points, out);
    if (needsTangents) writeTangents(request, out.normals);
}

void CpuEvaluator::writeTangents(const EvaluationRequest& request, std::span<const glm::vec3> normals) {
    constexpr std::size_t blockSize = 4096;
    const gl::BufferMapping mapping(request.buffers.tangents, normals.size() * sizeof(glm::vec4),
                                    gl::MappingAccess::readWrite);
    const std::span<glm::vec4> tangents = mapping.elements<glm::vec4>(0, normals.size());
    ThreadPool::shared()->run((normals.size() + blockSize - 1) / blockSize, [&](std::size_t block, unsigned) {
        const std::size_t end = std::min((block + 1) * blockSize, normals.size());
        for (std::size_t i = block * blockSize; i < end; ++i)
            tangents[i] = limitTangent(normals[i], du_[i], dv_[i], request.uvDerivatives[i]);
    });
}

const char* toString(VertexEvaluator evaluator) {
    switch (evaluator) {
        case VertexEvaluator::cpu:
            return "cpu";
        case VertexEvaluator::compute:
            return "compute";
        default:
            return "auto";
    }
}

EvaluatorBackend::EvaluatorBackend(const Context& context, VertexEvaluator evaluator)
    : evaluator_(evaluator) {
    if (evaluator_ == VertexEvaluator::automatic)
        evaluator_ = context.isSoftware() ? VertexEvaluator::cpu : VertexEvaluator::compute;
}

bool EvaluatorBackend::usesCompute(const EvaluationRequest& request) {
    if (evaluator_ != VertexEvaluator::compute) return false;
    if (!compute_) compute_.emplace();
    return compute_->supports(request);
}

void EvaluatorBackend::evaluate(const EvaluationRequest& request) {
    if (usesCompute(request)) {
        compute_->evaluate(request);
        lastUsed_ = VertexEvaluator::compute;
    } else {
        cpu_.evaluate(request);
        lastUsed_ = VertexEvaluator::cpu;
    }
}

}  // namespace candela
