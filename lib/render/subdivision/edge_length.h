#pragma once

#include "render/frustum.h"
#include "render/subdivision/cage_edges.h"

#include <glm/vec3.hpp>

#include <optional>
#include <span>

namespace candela {

/// From where the length of edges on the screen is told.
struct Sight {
    Frustum frustum;
    glm::vec3 eye;
    float nearPlane;         ///< Metres; nothing counts as nearer than this.
    float pixelsAtOneMetre;  ///< The length on the screen of 1 m at a distance of 1 m.
};

/// The sight of a picture of `width` × `height` pixels.
Sight sightOf(const CameraView& view, int width, int height);

/// The greatest length of those edges that may lie in the view, in pixels: that of each as if it stood square
/// to the eye at the distance of its nearer end. None where none does. Points are in the world.
std::optional<float> longestEdge(const Sight& sight, std::span<const glm::vec3> points,
                                 std::span<const CageEdge> edges);

}  // namespace candela
