// Counts instead of shading: red counts the pairs whose pixel lies within the light's range, green those that were evaluated. With SHADOWS
// blue counts the occlusion rays; SPOT is 1 for spots and 0 for point lights then.

#include "lib/lighting.glsl"

layout(early_fragment_tests) in;

layout(location = 0) flat in vec4 lightPlace;
#ifdef SHADOWS
layout(location = 1) flat in vec4 lightIntensity;
layout(location = 2) flat in vec4 lightCone;
#endif

layout(location = 0) out vec4 pairs;

void main() {
    PixelSurface pixel = fetchSurface(ivec2(gl_FragCoord.xy));
    LocalLight light = localLightOf(lightPlace, vec4(0.0));
    bool inRange = pixel.lit && isLit(pixel.position, light);
    pairs = vec4(inRange ? 1.0 : 0.0, pixel.lit ? 1.0 : 0.0, 0.0, 0.0);
#ifdef SHADOWS
#if SPOT == 1
    bool reached = isReached(pixel, light, lightConeOf(lightCone));
#else
    bool reached = isReached(pixel, light);
#endif
    pairs.b = pixel.lit && reached && lightIntensity.w != 0.0 ? 1.0 : 0.0;
#endif
}
