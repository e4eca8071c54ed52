// Radiance and coverage of a layer of transparent surfaces, where it has a surface.

#include "lib/gbuffer_input.glsl"

layout(binding = LAYER_UNIT) uniform usampler2D layerTexture;
layout(binding = LAYER_COLOR_UNIT) uniform sampler2D radianceTexture;

layout(location = 0) out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint word = texelFetch(layerTexture, pixel, 0).x;
    if (word == 0u) discard;
    color = vec4(texelFetch(radianceTexture, pixel, 0).rgb, unpackCoverage(word));
}
