#pragma once

#include <candela/scene.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace candela {

/// The orthonormal axes of a node's frame: its world matrix without translation, scale and shear. Z keeps its
/// direction, Y is made perpendicular to it, X completes them on the side where the matrix has it: a mirror
/// stays a mirror. Axes that the matrix collapses to nothing are replaced by perpendicular ones.
glm::dmat3 unscaledFrame(const glm::mat4& world);

/// One of `worldLights`.
WorldLight worldLight(const Light& light, const std::vector<glm::mat4>& world);

}  // namespace candela
