#pragma once

#include "gl/texture.h"
#include "render/debug/instance_pass.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// Where vertices were at the last `GpuScene::keepPoses`, of meshes and cages whose vertices have moved
/// within them since: by a skin, morph targets, points of a cage, or a frame callback.
class PreviousVertices {
  public:
    /// Those of the instances that `seen` names.
    PreviousVertices(GpuScene::State& scene, std::span<const SurfaceId> seen);

    bool empty() const { return vertices_.empty(); }
    /// For shaders: uploads what `surface_instance.vert` reads, and binds it.
    void bind();

  private:
    void add(std::uint32_t instance, const std::vector<glm::vec3>& positions, std::int32_t baseVertex);

    std::vector<glm::vec4> vertices_;
    /// For each instance what is added to the number of a vertex; `PREVIOUS_NONE`: its vertices rest.
    std::vector<std::int32_t> offsets_;
    gl::BufferTexture vertexTexture_, offsetTexture_;
};

}  // namespace candela
