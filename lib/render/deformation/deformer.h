#pragma once

#include "gl/program.h"
#include "render/deformation/mesh_deformation.h"

#include <candela/context.h>
#include <candela/gpu_scene.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// The vertex buffers that a deformation writes: position and normal of each vertex, interleaved; and the
/// tangents in another, if there are any.
struct DeformedBuffers {
    gl::Buffer surface{"deformed positions and normals", gl::BufferUsage::device};
    gl::Buffer tangents{"deformed tangents", gl::BufferUsage::device};
};

/// A deformation of a mesh. The buffers have room for the result.
struct DeformRequest {
    MeshDeformation& mesh;
    const PosedJoints* joints;            ///< nullptr: no skin moves the mesh.
    std::span<const float> morphWeights;  ///< Empty: no target moves the mesh.
    const DeformedBuffers& buffers;
};

/// Deforms meshes in a compute shader.
class ComputeDeformer {
  public:
    ComputeDeformer();

    /// Do the buffers of the request fit the device's storage blocks?
    bool supports(const DeformRequest& request) const;
    void deform(std::span<const DeformRequest> requests);

  private:
    void dispatch(const DeformRequest& request, std::size_t firstPose) const;

    gl::Program program_;
    std::size_t maxBlock_ = 0;  ///< Bytes.
    std::vector<float> poses_;  ///< Of each request the joints' rows, and the morph weights.
    gl::Buffer poseBuffer_{"poses", gl::BufferUsage::dynamic};
};

/// Deforms meshes on the threads of the shared pool, straight into mapped buffers.
class CpuDeformer {
  public:
    static void deform(std::span<const DeformRequest> requests);
};

/// Deforms meshes with the CPU on a software rasteriser and the compute shader on a GPU, or as the options
/// say. What the compute shader does not support, the CPU deforms.
class Deformer {
  public:
    Deformer(const Context& context, VertexEvaluator evaluator);

    void deform(std::span<const DeformRequest> requests);
    /// What the last call has used; `automatic` before the first.
    VertexEvaluator lastUsed() const { return lastUsed_; }

  private:
    VertexEvaluator evaluator_;
    VertexEvaluator lastUsed_ = VertexEvaluator::automatic;
    std::optional<ComputeDeformer> compute_;  ///< Created when it is first used.
    std::vector<DeformRequest> onDevice_, onCpu_;
};

}  // namespace candela
