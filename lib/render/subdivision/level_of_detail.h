#pragma once

#include "render/frustum.h"
#include "render/subdivision/cage_edges.h"

#include <candela/gpu_scene.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

namespace candela {

/// How many vertices, edges, faces and face corners a cage has.
struct CageSize {
    std::uint64_t vertices = 0, edges = 0, faces = 0, corners = 0;
};

/// The number of distinct points after uniform refinement to `level` (1 or more): each level adds one for
/// every edge and, except in Loop's scheme, one for every face. Seam vertices are not counted. Faces that
/// holes and boundaries leave out are.
std::uint64_t refinedPoints(SubdivisionScheme scheme, const CageSize& size, std::uint32_t level);

/// The maximum level that `settings` allow a cage whose level follows its size on the screen, 1 or more.
std::uint32_t maxLevel(SubdivisionScheme scheme, const CageSize& size, const SubdivisionSettings& settings);

/// What the screen-space length of an edge depends on.
struct LodView {
    Frustum frustum;
    glm::vec3 eye;
    float nearPlane;         ///< Metres; the minimum distance of any point.
    bool orthographic;       ///< The size on the screen does not depend on the distance.
    float pixelsAtOneMetre;  ///< The length on the screen of 1 m, in a perspective view at a distance of 1 m.

    /// The length on the screen, in pixels, of `length` metres at `distance` metres from the eye.
    float pixels(float length, float distance) const {
        if (orthographic) return length * pixelsAtOneMetre;
        return length * pixelsAtOneMetre / std::max(distance, nearPlane);
    }
};

/// The view of a picture of `width` × `height` pixels.
LodView lodView(const CameraView& view, int width, int height);

/// The length, in pixels, of the longest edge that may lie in the view. An edge counts with the length that
/// it has when it is perpendicular to the view direction at the distance of its nearer end. None where no
/// edge may lie in the view. Points are in world space.
std::optional<float> longestEdge(const LodView& view, std::span<const glm::vec3> points,
                                 std::span<const CageEdge> edges);

/// The level at which edges of `longestEdge` pixels are no longer than `edgePixels`, as a real number.
float idealLevel(float longestEdge, float edgePixels);

/// The level after `current` (none at first) where the ideal one is `ideal`: `ideal` rounded up, from 1 to
/// `maxLevel`. Hysteresis: the current level, which serves ideal levels from level - 1 to level, is kept
/// until the ideal one is 0.25 outside of that.
std::uint32_t nextLevel(std::optional<std::uint32_t> current, float ideal, std::uint32_t maxLevel);

/// Throws `Error` (badInput) naming the setting that is out of its range.
void checkSettings(const SubdivisionSettings& settings);

}  // namespace candela
