#pragma once

#include <candela/image.h>

#include <glm/gtc/quaternion.hpp>

#include <optional>

namespace candela {

/// Light from everywhere: a picture of what surrounds a scene, infinitely far away.
struct Environment {
    /// Radiance in linear Rec.709, candela per square metre, 0 or more; alpha is not read. Equirectangular:
    /// rows from the top (+Y), columns from the left, where the middle column lies at -Z, the quarter to its
    /// right at +X and the borders at +Z. Its format is `PixelFormat::rgba32f`.
    Image picture;
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  ///< World from the picture's frame; unit length.
    float intensity = 1.0f;                      ///< Factor on the radiance, 0 or more and finite.
    bool isBackground = true;  ///< Whether it is seen behind the scene, where no surface is.
    /// Metres, over 0: surfaces farther from a point than this do not hide the environment from it. None:
    /// every surface hides what lies behind it.
    std::optional<float> occlusionDistance = {};
};

}  // namespace candela
