#pragma once

#include <candela/subdivider.h>

#include <glm/vec3.hpp>

#include <array>

namespace candela {

/// The colours between which the heat map blends, in equal steps from share 0 to share 1.
constexpr std::array<glm::vec3, 5> heatStops{glm::vec3(0.0f), glm::vec3(0.0f, 0.0f, 1.0f),
                                             glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(1.0f, 1.0f, 0.0f),
                                             glm::vec3(1.0f, 0.0f, 0.0f)};

/// The colours of subdivision levels: grey-blue polygons, then round the hues, so that neighbours are easily
/// told apart.
constexpr std::array<glm::vec3, maxSubdivisionLevel + 1> levelColors{
    glm::vec3(0.35f, 0.40f, 0.50f), glm::vec3(0.20f, 0.30f, 0.95f), glm::vec3(0.10f, 0.70f, 0.95f),
    glm::vec3(0.10f, 0.80f, 0.55f), glm::vec3(0.35f, 0.80f, 0.10f), glm::vec3(0.90f, 0.85f, 0.10f),
    glm::vec3(0.95f, 0.50f, 0.10f), glm::vec3(0.90f, 0.15f, 0.15f), glm::vec3(0.85f, 0.15f, 0.80f)};

/// What meshes have in the view of levels.
constexpr glm::vec3 meshColor(0.5f);

}  // namespace candela
