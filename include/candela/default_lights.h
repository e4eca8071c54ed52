#pragma once

#include <candela/camera.h>
#include <candela/export.h>
#include <candela/scene.h>

#include <array>

namespace candela {

/// Whether a scene brings light: a light of an intensity and a colour over 0, an environment of an intensity
/// over 0, or a material that a node shows and that is unlit or emits. A material with an emission texture
/// emits where more than half of the texture is over black: few lamps or displays on an object do not light
/// it. An intensity, a colour or an emission that an animation which plays brings over 0 counts too.
CANDELA_API bool hasLight(const Scene& scene);

/// Three directional lights that show an object without light of its own from any side: a key light from the
/// upper left of the camera, a fill light from the right and a rim light from above behind the object. A grey
/// surface that faces the camera shows as itself: a matte one of base colour 0.18 has a radiance of 0.18 /
/// 2^`exposure`, up to 1 % (`exposure` in stops, -100 to 100). They cast no shadows: they stand in for the
/// light that the scene lacks, and have to reach the inside of a closed room too. Throws `Error` (badInput)
/// when the view's matrix is not finite or the exposure is out of its range.
CANDELA_API std::array<WorldLight, 3> defaultLights(const CameraView& view, double exposure = 0.0);

/// A directional light from the camera, which moves with it: whatever is in view is lit from the front. A
/// grey surface that faces the camera shows as with `defaultLights`. It casts no shadow. Throws as
/// `defaultLights` does.
CANDELA_API WorldLight headlight(const CameraView& view, double exposure = 0.0);

}  // namespace candela
