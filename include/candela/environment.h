#pragma once

#include <candela/export.h>
#include <candela/image.h>
#include <candela/light.h>

#include <glm/gtc/quaternion.hpp>

#include <optional>

namespace candela {

/// Light from everywhere: a picture of what surrounds a scene, infinitely far away.
struct Environment {
    /// Radiance in linear Rec.709, candela per square metre, 0 or more; alpha is not read. Equirectangular:
    /// rows from the top (+Y), columns from the left, where the middle column lies at -Z, the quarter to its
    /// right at +X and the borders at +Z. Its format is `PixelFormat::rgba32f`.
    Image picture = {};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  ///< World from the picture's frame; unit length.
    float intensity = 1.0f;                      ///< Factor on the radiance, 0 or more and finite.
    bool isBackground = true;  ///< Whether it is seen behind the scene, where no surface is.
    /// Metres, over 0: surfaces farther from a point than this do not hide the environment from it. None:
    /// every surface hides what lies behind it.
    std::optional<float> occlusionDistance = {};
};

/// What of an `Environment` changes without a new picture: see there.
struct EnvironmentSettings {
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    float intensity = 1.0f;
    bool isBackground = true;
    std::optional<float> occlusionDistance = {};
};

/// The rotation by `degrees` about +Y, counter-clockwise as seen from above: by 90, what is at -Z gets to -X.
/// Throws `Error` (badInput) unless they are finite.
CANDELA_API glm::quat rotationAboutUp(double degrees);

/// A photographer's studio: five white soft boxes in a grey room. A white matte surface has a radiance of 0.3
/// to 1, and of 0.77 where it faces +Z, the side of the camera that frames a scene by itself. The studio is
/// not seen behind the scene. Its picture has 512 x 256 texels, the same on every machine.
CANDELA_API Environment studioEnvironment();

struct SkyOptions {
    double sunElevation = 0.7;  ///< Of the sun above the horizon: radians, pi / 60 to pi / 2.
    double sunAzimuth = -2.4;   ///< From -Z towards +X: radians, -pi to pi.
    double turbidity = 3.0;     ///< How hazy the air is: 2 (very clear) to 8.
};

/// A cloudless sky by day without its sun, and the sun as a directional light.
struct Sky {
    Environment environment = {};  ///< Below the horizon lies grey ground.
    Light sun = {};                ///< It casts shadows.
};

/// A clear sky by the model of Preetham, Shirley and Smits, "A Practical Analytic Model for Daylight", 1999.
/// Sky and sun are scaled by one factor, with which a white matte horizontal surface in the open has a
/// luminance of 1. The picture has 512 x 256 texels, the same on every machine. Throws `Error` (badInput)
/// when an option is out of its range.
CANDELA_API Sky skyEnvironment(const SkyOptions& options = {});

/// Takes the sun out of an environment whose picture has one, and returns it as a directional light in world
/// space that casts shadows. There is a sun where what is brighter within 4 degrees of a point than the mean
/// of the 2 degrees around gives at least a tenth of the light of an average surface (pi times the mean
/// radiance), and its brightest texel has 20 times the luminance of that mean, which takes the sun's place.
/// Light is conserved: the two together give every surface that has all of the 4 degrees above its horizon
/// the irradiance that the picture gave. None, and nothing changes, without a sun and in a picture of fewer
/// than 128 x 64 texels. Throws `Error` (badInput) when the environment breaks a rule of `validate`.
CANDELA_API std::optional<Light> takeSun(Environment& environment);

}  // namespace candela
