#include "render/subdivision/cpu_evaluator.h"

#include "base/thread_pool.h"
#include "render/subdivision/gpu_stencil_table.h"
#include "render/subdivision/limit_tangent.h"

#include <candela/error.h>

#include <algorithm>
#include <string>

namespace candela {

namespace {

/// The first `bytes` of a buffer in the program's memory.
class Mapping {
  public:
    Mapping(const gl::Buffer& buffer, std::size_t bytes)
        : name_(buffer.name()),
          // Read as well: twins copy what has been written for their points.
          memory_(glMapNamedBufferRange(name_, 0, static_cast<GLsizeiptr>(bytes),
                                        GL_MAP_READ_BIT | GL_MAP_WRITE_BIT)) {
        if (memory_ != nullptr) return;
        throw Error(ErrorKind::limit, "",
                    "the device can not map a buffer of " + std::to_string(bytes) + " bytes");
    }
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;
    ~Mapping() { glUnmapNamedBuffer(name_); }

    template <typename T>
    std::span<T> elements(std::size_t first, std::size_t count) const {
        return {static_cast<T*>(memory_) + first, count};
    }

  private:
    GLuint name_;
    void* memory_;
};

}  // namespace

void CpuEvaluator::evaluate(const LimitRequest& request) {
    const RefinedCage& refined = request.table.refined();
    const std::size_t vertices = refined.vertexCount();
    if (vertices == 0) return;
    const Mapping surface(request.streams.surface, LimitStreams::surfaceBytes(vertices));
    LimitVertices out{
        surface.elements<glm::vec3>(0, vertices), surface.elements<glm::vec3>(vertices, vertices), {}, {}};
    const bool wantsTangents = !request.uvDerivatives.empty();
    if (wantsTangents) {
        du_.resize(vertices);
        dv_.resize(vertices);
        out.du = du_;
        out.dv = dv_;
    }
    evaluateLimit(refined, request.points, out);
    if (wantsTangents) writeTangents(request, out.normals);
}

void CpuEvaluator::writeTangents(const LimitRequest& request, std::span<const glm::vec3> normals) {
    constexpr std::size_t blockSize = 4096;
    const Mapping mapping(request.streams.tangents, normals.size() * sizeof(glm::vec4));
    const std::span<glm::vec4> tangents = mapping.elements<glm::vec4>(0, normals.size());
    ThreadPool::shared()->run((normals.size() + blockSize - 1) / blockSize, [&](std::size_t block, unsigned) {
        const std::size_t end = std::min((block + 1) * blockSize, normals.size());
        for (std::size_t i = block * blockSize; i < end; ++i)
            tangents[i] = limitTangent(normals[i], du_[i], dv_[i], request.uvDerivatives[i]);
    });
}

}  // namespace candela
