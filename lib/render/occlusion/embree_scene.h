#pragma once

#include "render/occlusion/occlusion_mesh.h"
#include "render/occlusion/ray_packet.h"

#include <cstdint>
#include <memory>
#include <span>

namespace candela {

/// Meshes and their instances as Embree traces them: a tree a mesh, and one over the instances. Changes take
/// effect with `commit`.
class EmbreeScene {
  public:
    /// Throws `Error` (environment) when Embree does not start on this processor.
    EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;
    ~EmbreeScene();

    /// Sets mesh `index`. Where the triangles are those of before, its tree is refitted. Throws `Error`
    /// (limit) when memory does not hold it.
    void setMesh(std::uint32_t index, std::shared_ptr<const OcclusionMesh> mesh);
    /// Sets instance `index`, of a mesh that is set. An instance whose matrix is singular, or not finite,
    /// hides nothing.
    void setInstance(std::uint32_t index, const OcclusionInstance& instance);
    /// Lets an instance hide nothing until it is set again. One that was never set stays absent.
    void disableInstance(std::uint32_t index);
    /// Brings the trees over the instances up to date, at a cost in proportion to what has changed.
    void commit();

    /// Memory of all trees, bytes.
    std::uint64_t bytes() const;

    /// See `TracePacket`. Any thread may call it between two commits.
    std::uint32_t trace(const RayPacket& packet, float* transmittance) const;
    /// `trace` for `TracePacket`.
    static std::uint32_t tracePacket(const void* scene, const RayPacket& packet, float* transmittance);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace candela
