// Shades one light at one pixel of its volume.

#include "lib/surface.glsl"
#include "lib/lights.glsl"

layout(early_fragment_tests) in;

layout(location = 0) flat in vec4 lightPlace;
layout(location = 1) flat in vec4 lightIntensity;
layout(location = 2) flat in vec4 lightCone;

layout(location = 0) out vec4 radiance;

void main() {
    ShadingPoint point;
    bool lit = fetchShadingPoint(ivec2(gl_FragCoord.xy), point);
    LocalLight light = LocalLight(lightPlace.xyz, lightPlace.w, lightIntensity.rgb);
#if SPOT == 1
    vec3 sum = spotLight(point, light, lightCone);
#else
    vec3 sum = pointLight(point, light, 1.0);
#endif
    // No discard: a fragment that is discarded would leave its mark in the stencil.
    radiance = vec4(lit ? sum : vec3(0.0), 0.0);
}
