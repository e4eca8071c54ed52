// Counts instead of shading: red pairs whose pixel lies within the light's range, green pairs that were evaluated.

#include "lib/surface.glsl"
#include "lib/lights.glsl"

layout(early_fragment_tests) in;

layout(location = 0) flat in vec4 lightPlace;

layout(location = 0) out vec4 pairs;

void main() {
    ShadingPoint point;
    bool surface = fetchShadingPoint(ivec2(gl_FragCoord.xy), point);
    bool lit = surface && isLit(point, LocalLight(lightPlace.xyz, lightPlace.w, vec3(0.0)));
    pairs = vec4(lit ? 1.0 : 0.0, surface ? 1.0 : 0.0, 0.0, 0.0);
}
