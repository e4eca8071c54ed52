#pragma once

#include <glm/vec3.hpp>

/// A colour as people edit it: what it looks like, and how strong it is.
struct SplitColor {
    glm::vec3 hue{1.0f};    ///< Its greatest channel is 1.
    float strength = 0.0f;  ///< 0 or more; the colour is hue × strength.

    glm::vec3 joined() const { return hue * strength; }
};

/// `color` has channels of 0 or more. Black keeps `hueOfBlack`, so that a light that was dimmed to nothing
/// comes back in its colour.
SplitColor splitColor(const glm::vec3& color, const glm::vec3& hueOfBlack = glm::vec3(1.0f));
