// Shades one light at one pixel of its volume. SPOT is 1 for spots and 0 for point lights.

#include "lib/lighting.glsl"

layout(early_fragment_tests) in;

layout(location = 0) flat in vec4 lightPlace;
layout(location = 1) flat in vec4 lightIntensity;
layout(location = 2) flat in vec4 lightCone;

layout(location = 0) out vec4 radiance;

void main() {
    PixelSurface pixel = fetchSurface(ivec2(gl_FragCoord.xy));
    ShadingPoint point = shadingPointOf(pixel);
    LocalLight light = localLightOf(lightPlace, lightIntensity);
#if SPOT == 1
    vec3 sum = spotLightRadiance(BRDF, point, light, lightConeOf(lightCone));
#else
    vec3 sum = pointLightRadiance(BRDF, point, light);
#endif
    // No discard: a discarded fragment would leave its mark in the stencil.
    radiance = vec4(pixel.lit ? sum : vec3(0.0), 0.0);
}
