#pragma once

#include "render/gpu_scene/gpu_scene_state.h"

#include <candela/scene.h>
#include <candela/subdivider.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace candela::test {

/// The subdivider of the build's plugins.
const Subdivider& subdivider();

/// A cube around the origin. Each face has texture coordinates of its own, so that every edge is a seam.
Cage makeCubeCage(float halfSize);

/// The same with all edges infinitely sharp; its limit surface is the cube.
Cage makeSharpCubeCage(float halfSize);

/// The square of `makeQuad` as `cells` × `cells` faces, with its texture coordinates; flat, and so is its
/// limit surface.
Cage makeSheetCage(float halfSize, std::uint32_t cells);

/// Moves each point by up to `distance` along each axis, differently for each `seed`.
std::vector<glm::vec3> jittered(const std::vector<glm::vec3>& points, float distance, std::uint32_t seed);

/// Adds a cage of `material`, and a node that shows it. Returns the node's index.
std::uint32_t placeCage(Scene& scene, Cage cage, const Material& material,
                        const glm::mat4& transform = glm::mat4(1.0f));

Scene sceneOfCage(Cage cage, const Material& material, const glm::mat4& transform = glm::mat4(1.0f));

/// With the plugins' subdivider; all cages at `level`, if there is one.
GpuSceneOptions subdividing(std::optional<std::uint32_t> level = std::nullopt);

/// The vertices that were drawn last for `GpuCages::instances()[index]`.
struct DrawnVertices {
    std::vector<glm::vec3> positions, normals;
};
DrawnVertices drawnVertices(GpuScene& scene, std::uint32_t index = 0);

}  // namespace candela::test
