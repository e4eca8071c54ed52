#pragma once

#include "render/frustum.h"
#include "render/gpu_scene/record_buffer.h"
#include "render/layout.h"

#include <candela/scene.h>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace candela {

/// A sphere that holds what is drawn.
struct BoundingSphere {
    glm::vec3 center{0.0f};
    float radius = 0.0f;
};

BoundingSphere boundingSphere(std::span<const glm::vec3> points);
/// A world-space sphere that holds the local one.
BoundingSphere worldSphere(const glm::mat4& worldFromLocal, const BoundingSphere& local);

/// Which vertices a frame needs.
enum class VertexScope {
    inView,
    everywhere,  ///< What is out of view may cast shadows into it.
};

/// Does an instance's matrix reverse the winding of triangles?
enum class Winding : std::uint8_t { kept, reversed };

/// A mesh or a cage of a node.
struct Instance {
    std::uint32_t node = 0;
    std::optional<std::uint32_t> mesh;  ///< Index into `Scene::meshes`; none: it is a cage.
    std::uint32_t cageInstance = 0;     ///< Index into `GpuCages::instances` for a cage.
    bool isRemoved = false;             ///< The place is free.
};

/// The meshes and cages of the nodes: first the meshes, then the cages, each in the order of the nodes, and
/// then those added later.
class GpuInstances {
  public:
    explicit GpuInstances(const Scene& scene);

    std::size_t size() const { return instances_.size(); }
    const Instance& operator[](std::uint32_t index) const { return instances_[index]; }

    /// The instance of a node's mesh, or of its cage; none where the node has none.
    std::optional<std::uint32_t> meshOf(std::uint32_t node) const { return indexOf(meshOfNode_[node]); }
    std::optional<std::uint32_t> cageOf(std::uint32_t node) const { return indexOf(cageOfNode_[node]); }

    enum class Elements { trianglesOnly, linesOrPoints };
    /// Adds the mesh of a node, to be placed next, and returns its instance. The node may be a new one.
    std::uint32_t addMesh(std::uint32_t node, std::uint32_t mesh, Elements elements);
    /// The same of its cage, which is instance `cageInstance` of `GpuCages`.
    std::uint32_t addCage(std::uint32_t node, std::uint32_t cageInstance);
    /// Removes the mesh, or the cage, of a node.
    void removeMesh(std::uint32_t node) { remove(meshOfNode_[node]); }
    void removeCage(std::uint32_t node) { remove(cageOfNode_[node]); }
    /// To be called when the mesh of an instance has become another one.
    void setElements(std::uint32_t index, Elements elements) {
        hasElements_[index] = elements == Elements::linesOrPoints;
    }
    /// To be called when a node without a mesh and a cage is added at the end.
    void addNode() {
        meshOfNode_.push_back(none);
        cageOfNode_.push_back(none);
    }
    /// All instances in the order in which those of a new scene are.
    std::vector<std::uint32_t> inNodeOrder() const;

    /// Writes the record of an instance. `winding` is that of the matrix unless given: the vertices of a
    /// skinned mesh may be mirrored themselves.
    void place(std::uint32_t index, const glm::mat4& worldFromLocal, const BoundingSphere& local,
               std::optional<Winding> winding = {});
    /// As of the last `place`.
    Winding winding(std::uint32_t index) const { return windings_[index]; }
    /// A world-space box that holds all instances, hidden ones included. Computed anew only where an instance
    /// that touched its sides has moved.
    const Bounds& bounds();
    /// Uploads the records written since the last call. Returns how many those are.
    std::size_t upload() { return records_.upload(); }

    /// The depth of the farthest point of an instance's bounding sphere; negative behind the eye.
    float farthestDepth(std::uint32_t index, const Frustum& frustum) const {
        return frustum.inCameraSpace(spheres_[index].center).z + spheres_[index].radius;
    }
    /// The depth of the farthest point that the bounding spheres in view reach; 0 where there is none.
    float farthestDepth(const Frustum& frustum) const;

    void setHidden(std::uint32_t index, bool hidden) {
        hidden_[index] = hidden;
        markChanged(index);
    }
    bool isHidden(std::uint32_t index) const { return hidden_[index]; }
    /// The instances placed, hidden or shown since the last call, each once.
    std::vector<std::uint32_t> takeChanged();
    void markChanged(std::uint32_t index) {
        if (isChanged_[index]) return;
        isChanged_[index] = true;
        changed_.push_back(index);
    }
    bool isVisible(std::uint32_t index, const Frustum& frustum) const {
        return !hidden_[index] && frustum.meets(spheres_[index].center, drawnRadius(index, frustum));
    }

    /// Of a sphere around the instance's that holds what is drawn, the width of lines and points included.
    float drawnRadius(std::uint32_t index, const Frustum& frustum) const {
        const auto& [center, radius] = spheres_[index];
        return hasElements_[index] ? frustum.radiusOfElements(center, radius) : radius;
    }

    /// World space.
    const BoundingSphere& sphere(std::uint32_t index) const { return spheres_[index]; }

    /// The record of an instance as shaders read it.
    std::span<const glm::vec4> record(std::uint32_t index) const {
        return records_.texels().subspan(std::size_t{index} * layout::INSTANCE_TEXELS,
                                         layout::INSTANCE_TEXELS);
    }
    /// As in the record.
    glm::mat4 worldFromLocal(std::uint32_t index) const { return matrixOf(records_.texels(), index); }
    /// Remembers where the instances are.
    void keep() {
        kept_.assign(records_.texels().begin(), records_.texels().end());
        isNew_.assign(instances_.size(), false);
    }
    /// Has an instance been added since the last `keep`, or was there none?
    bool isNew(std::uint32_t index) const { return kept_.empty() || isNew_[index]; }
    /// Where an instance was at the last `keep`; before, and where it has been added since, where it is.
    glm::mat4 keptWorldFromLocal(std::uint32_t index) const {
        return matrixOf(isNew(index) ? records_.texels() : std::span<const glm::vec4>(kept_), index);
    }
    const gl::BufferTexture& records() const { return records_.texture(); }

  private:
    static constexpr std::uint32_t none = 0xffffffffu;

    void leaveBounds(std::uint32_t index);
    void joinBounds(std::uint32_t index);
    std::uint32_t take(const Instance& instance);
    void remove(std::uint32_t& ofNode);
    static std::optional<std::uint32_t> indexOf(std::uint32_t index) {
        return index == none ? std::nullopt : std::optional(index);
    }

    static glm::mat4 matrixOf(std::span<const glm::vec4> records, std::uint32_t index) {
        const auto rows = records.subspan(std::size_t{index} * layout::INSTANCE_TEXELS, 3);
        return glm::transpose(glm::mat4(rows[0], rows[1], rows[2], glm::vec4(0.0f, 0.0f, 0.0f, 1.0f)));
    }

    std::vector<Instance> instances_;
    std::vector<std::uint32_t> meshOfNode_, cageOfNode_;
    std::vector<BoundingSphere> spheres_;  ///< World.
    Bounds bounds_;                        ///< Of all spheres, unless stale.
    bool boundsAreStale_ = true;
    std::vector<Winding> windings_;
    std::vector<bool> hasElements_;  ///< Lines or points.
    std::vector<bool> hidden_, isChanged_;
    std::vector<std::uint32_t> changed_, free_;
    RecordBuffer<glm::vec4> records_;
    std::vector<glm::vec4> kept_;  ///< The records at the last `keep`; empty before.
    std::vector<bool> isNew_;      ///< Since then.
};

}  // namespace candela
