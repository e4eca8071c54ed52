// Shades one light at one pixel of its volume. SPOT is 1 for spots and 0 for point lights.

#include "lib/lighting.glsl"

layout(early_fragment_tests) in;

layout(location = 0) flat in vec4 lightPlace;
layout(location = 1) flat in vec4 lightIntensity;
layout(location = 2) flat in vec4 lightCone;

layout(location = 0) out vec4 radiance;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    PixelSurface pixel = fetchSurface(at);
    Receiver receiver = receiverAt(at, pixel);
    LocalLight light = localLightOf(lightPlace, lightIntensity);
    bool hasShadow = pixel.lit && lightIntensity.w != 0.0;
#if SPOT == 1
    vec3 sum = spotLight(receiver, light, lightConeOf(lightCone), hasShadow);
#else
    vec3 sum = pointLight(receiver, light, hasShadow);
#endif
    // No discard: a discarded fragment would leave its mark in the stencil.
    radiance = vec4(pixel.lit ? sum : vec3(0.0), 0.0);
}
