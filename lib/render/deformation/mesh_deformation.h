#pragma once

#include "gl/buffer.h"
#include "render/deformation/deform_kernel.h"
#include "render/gpu_scene/gpu_instances.h"
#include "render/gpu_scene/gpu_meshes.h"

#include <candela/mesh.h>

#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// The joints' matrices of a posed skin, as `DeformJob` reads them, with what follows from them.
struct PosedJoints {
    std::vector<float> rows;          ///< 12 a joint.
    float directionScale = 1.0f;      ///< See `DeformJob`.
    Winding winding = Winding::kept;  ///< Reversed where most joints mirror.
};

PosedJoints posedJoints(std::span<const glm::dmat4x3> matrices);

/// What deforms the vertices of a mesh, packed for the kernels and for the compute shader.
class MeshDeformation {
  public:
    /// Tangents are deformed where the mesh has them and draws read them.
    MeshDeformation(const Mesh& mesh, GpuMeshes::Detail detail);

    std::uint32_t vertexCount() const { return vertices_; }
    std::uint32_t blockCount() const {
        return vertices_ / deformBlockSize + (vertices_ % deformBlockSize != 0);
    }
    bool hasTangents() const { return hasTangents_; }
    std::size_t surfaceBytes() const { return std::size_t{vertices_} * restColumns * sizeof(float); }
    std::size_t tangentBytes() const { return std::size_t{vertices_} * 4 * sizeof(float); }

    /// A job that lacks joints, morph weights and where to write to.
    DeformJob job() const;

    /// A sphere around the deformed mesh, in the space that `matrices` lead to: it holds the boxes of the
    /// vertices that each joint moves, as the joint takes them along. `morphWeights` may be empty.
    BoundingSphere bounds(std::span<const glm::dmat4x3> matrices, std::span<const float> morphWeights) const;
    /// A sphere around the mesh that only morph targets move.
    BoundingSphere bounds(std::span<const float> morphWeights) const;

    /// The same numbers for the compute shader.
    struct Storage {
        gl::Buffer rest, runs, influences, rows, entries;
    };
    /// Created on first use.
    const Storage& storage();
    /// The size of the largest buffer of the storage, bytes.
    std::size_t largestBuffer() const;

  private:
    void packRest(const Mesh& mesh);
    void packInfluences(const Mesh& mesh);
    void addInfluences(const Mesh& mesh, std::size_t vertex, std::size_t lane);
    void packMorphTargets(const Mesh& mesh);
    void boundJoints(const Mesh& mesh);
    /// How far morph targets move any vertex, metres.
    float morphReach(std::span<const float> weights) const;

    std::uint32_t vertices_;
    bool hasTangents_;
    std::vector<float> rest_;
    std::vector<std::uint32_t> runs_;
    std::vector<RunInfluence> influences_;
    std::vector<std::uint32_t> rows_;
    std::vector<MorphEntry> entries_;
    BoundingSphere sphere_;  ///< Of the mesh at rest.
    /// Around vertices at rest; empty where `low` is over `high`.
    struct Box {
        glm::vec3 low, high;
    };
    std::vector<Box> jointBoxes_;     ///< Of the vertices that each joint moves.
    std::vector<float> targetReach_;  ///< Of each target at the weight 1, metres.
    std::optional<Storage> storage_;
};

}  // namespace candela
