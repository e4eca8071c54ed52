#pragma once

#include "gl/program.h"
#include "render/subdivision/gpu_stencil_table.h"

#include <candela/context.h>
#include <candela/gpu_scene.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// The vertex buffers of a limit surface that an evaluation writes: all positions, then all normals, in one;
/// and the tangents in another, if there are any.
struct LimitBuffers {
    gl::Buffer surface{"cage positions and normals", gl::BufferUsage::device};
    gl::Buffer tangents{"cage tangents", gl::BufferUsage::device};

    static std::size_t surfaceBytes(std::size_t vertices) { return 2 * vertices * sizeof(glm::vec3); }
};

/// An evaluation of a limit surface: the stencil table is applied to the cage's points. The buffers have room
/// for the result.
struct EvaluationRequest {
    GpuStencilTable& table;
    std::span<const glm::vec3> points;
    const gl::Buffer& pointBuffer;  ///< The same points.
    /// Derivatives of the texture coordinates, one a vertex; empty where no tangents are needed.
    std::span<const glm::vec4> uvDerivatives;
    const LimitBuffers& buffers;
};

/// The tangent for normal maps at a limit vertex, as in `Mesh::tangents`: the direction in which u grows in
/// the surface; the bitangent points to decreasing v. `du` and `dv` are the surface's derivatives,
/// `uv` those of the texture coordinates, (du, dv), along the same parameters. Where the texture coordinates
/// span no area, any perpendicular to the normal.
glm::vec4 limitTangent(const glm::vec3& normal, const glm::vec3& du, const glm::vec3& dv,
                       const glm::vec4& uv);

/// Evaluates limit surfaces in a compute shader.
class ComputeEvaluator {
  public:
    ComputeEvaluator();

    /// Do the buffers of the request fit the device's storage blocks, and its stencils a loop of a shader?
    bool supports(const EvaluationRequest& request) const;
    void evaluate(const EvaluationRequest& request) const;

  private:
    void dispatch(std::size_t first, std::size_t end, const GpuStencilTable& table) const;

    gl::Program program_;
    std::size_t maxBlock_ = 0;  ///< Bytes.
};

/// Evaluates limit surfaces on the threads of the shared pool, straight into mapped buffers.
class CpuEvaluator {
  public:
    void evaluate(const EvaluationRequest& request);

  private:
    void writeTangents(const EvaluationRequest& request, std::span<const glm::vec3> normals);

    std::vector<glm::vec3> du_, dv_;
};

/// Evaluates limit surfaces with one of the evaluators: that of the options, or by default the CPU on a
/// software rasteriser and the compute shader on a GPU. What the compute shader does not support, the CPU
/// evaluates.
class EvaluatorBackend {
  public:
    EvaluatorBackend(const Context& context, VertexEvaluator evaluator);

    void evaluate(const EvaluationRequest& request);
    /// What the last evaluation has used; `automatic` before the first.
    VertexEvaluator lastUsed() const { return lastUsed_; }

  private:
    bool usesCompute(const EvaluationRequest& request);

    VertexEvaluator evaluator_;
    VertexEvaluator lastUsed_ = VertexEvaluator::automatic;
    std::optional<ComputeEvaluator> compute_;  ///< Created when it is first used.
    CpuEvaluator cpu_;
};

}  // namespace candela
