#pragma once

#include "render/deformation/deformer.h"

#include <candela/context.h>
#include <candela/gpu_scene.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// The nodes whose meshes are deformed: each has vertices of its own, which draws read in place of the
/// mesh's. Those out of view keep their vertices until they come into view.
class GpuDeformations {
  public:
    /// `kept` are the nodes, skins and animations as edits leave them; it has to outlive the object. `scene`
    /// has the meshes.
    GpuDeformations(const Context& context, const Scene& scene, const Scene& kept, GpuMeshes::Detail detail,
                    VertexEvaluator evaluator);

    bool empty() const { return instances_.empty(); }
    /// Places of deformed meshes, those that are free included.
    std::size_t size() const { return instances_.size(); }
    bool isFree(std::uint32_t index) const { return !instances_[index]; }

    /// Keeps what deforms mesh `mesh`, which may be a new one and which no node shows deformed.
    void setMesh(std::uint32_t mesh, const Mesh& from);
    /// Can nodes that are added show the mesh deformed?
    bool keeps(std::uint32_t mesh) const { return mesh < meshes_.size() && meshes_[mesh] != nullptr; }
    /// Adds the mesh of a node, which is kept and which the node deforms, and returns its index. Its vertices
    /// are to be described.
    std::uint32_t add(std::uint32_t node);
    void remove(std::uint32_t index);

    /// The deformed mesh of a node; none where its mesh is drawn as it is.
    std::optional<std::uint32_t> ofNode(std::uint32_t node) const;

    /// Does any node show the mesh deformed?
    bool deforms(std::uint32_t mesh) const;

    /// Where a deformed mesh stands, as of the last `pose`.
    struct Placement {
        std::uint32_t node = 0, mesh = 0;
        glm::mat4 worldFromLocal{1.0f};
        BoundingSphere sphere;           ///< Local.
        std::optional<Winding> winding;  ///< None: that of `worldFromLocal`.
    };
    const Placement& placement(std::uint32_t index) const { return instances_[index]->placement; }

    /// Describes the vertices of all instances to their vertex arrays. To be called again when the buffers of
    /// the meshes are other ones.
    void describe(const GpuMeshes& meshes, const gl::Buffer& drawRecords, const DefaultDetail& defaultDetail);
    /// The same of one instance.
    void describe(std::uint32_t index, const GpuMeshes& meshes, const gl::Buffer& drawRecords,
                  const DefaultDetail& defaultDetail);

    /// Marks the instances that a node moves: its own, and those for whose skin it is a joint.
    void markNode(std::uint32_t node);
    /// Marks the instances whose morph weights are animated.
    void markAnimated();
    /// To be called when other animations of the scene play.
    void selectAnimations();
    /// Poses the marked instances and returns them. `world` are the matrices of the nodes at `time`.
    std::span<const std::uint32_t> pose(const std::vector<glm::mat4>& world, double time);

    /// An instance whose vertices are not those of its pose.
    bool isStale(std::uint32_t index) const { return instances_[index]->isStale; }
    /// How often the vertices of an instance have been computed.
    std::uint64_t version(std::uint32_t index) const { return instances_[index]->version; }
    /// Computes the vertices of `indices`.
    void deform(std::span<const std::uint32_t> indices);

    /// Remembers the poses of all instances.
    void keep();
    /// The positions of an instance in the pose of the last `keep`; empty where its pose is the same.
    std::vector<glm::vec3> keptPositions(std::uint32_t index);

    GLuint vertexArray(std::uint32_t index) const { return instances_[index]->vertexArray.name(); }
    const DeformedBuffers& buffers(std::uint32_t index) const { return instances_[index]->buffers; }
    DeformationReport report() const;

  private:
    struct Instance {
        Placement placement;
        MeshDeformation* deformation = nullptr;
        std::optional<std::uint32_t> skin;         ///< Of those of the scene; none: morph targets alone.
        bool isAnimated = false;                   ///< The scene has animations of the morph weights.
        std::vector<AnimationChannel> animations;  ///< Those that play.
        std::vector<float> morphWeights;           ///< Empty: all 0.
        PosedJoints joints;
        PosedJoints keptJoints;
        std::vector<float> keptWeights;
        DeformedBuffers buffers;
        gl::VertexArray vertexArray{"deformed mesh"};
        bool isMarked = false, isStale = true;
        std::uint64_t version = 0;
    };

    void addInstances(const Scene& scene, GpuMeshes::Detail detail);
    void listJoints();
    void mark(std::uint32_t index);
    void poseInstance(Instance& instance, const std::vector<glm::mat4>& world, double time) const;

    const Scene& scene_;
    GpuMeshes::Detail detail_;
    std::vector<std::unique_ptr<MeshDeformation>> meshes_;  ///< One a mesh; nullptr: it is not deformed.
    std::vector<std::unique_ptr<Instance>> instances_;      ///< Null where the node has been removed.
    std::vector<std::vector<std::uint32_t>>
        instancesOfNode_;  ///< That a node moves; empty without instances.
    std::vector<std::uint32_t> marked_, posed_;
    std::vector<DeformRequest> requests_;
    Deformer deformer_;
};

}  // namespace candela
