// Counts instead of shading: red counts the pairs whose pixel lies within the light's range, green those that were evaluated.

#include "lib/lighting.glsl"

layout(early_fragment_tests) in;

layout(location = 0) flat in vec4 lightPlace;

layout(location = 0) out vec4 pairs;

void main() {
    PixelSurface pixel = fetchSurface(ivec2(gl_FragCoord.xy));
    bool inRange = pixel.lit && isLit(pixel.position, localLightOf(lightPlace, vec4(0.0)));
    pairs = vec4(inRange ? 1.0 : 0.0, pixel.lit ? 1.0 : 0.0, 0.0, 0.0);
}
