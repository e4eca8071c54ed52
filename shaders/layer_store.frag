// What is kept of a layer of transparent surfaces, where it has one: radiance and coverage, and with REFRACTION what is seen through it.

#include "lib/gbuffer_input.glsl"

#ifdef REFRACTION
#include "lib/lighting.glsl"

layout(binding = REFRACTION_UNIT) uniform usampler2D refractionTexture;

layout(location = 1) out uvec4 seenThrough;  // refraction words, with the transmittance of the surface in them; layer word; depth
#endif

layout(binding = LAYER_UNIT) uniform usampler2D layerTexture;
layout(binding = LAYER_COLOR_UNIT) uniform sampler2D radianceTexture;

layout(location = 0) out vec4 color;

#ifdef REFRACTION
uvec2 withSurface(ivec2 pixel, uint layerWord) {
    PixelSurface surface = fetchSurface(pixel);
    if (!surface.lit || !surface.extended) return uvec2(0u);
    uvec2 words = texelFetch(refractionTexture, pixel, 0).xy;
    vec3 transmittance = unpackRefraction(layerWord, words).transmittance;
    return uvec2(words.x, packTransmittance(transmittance * transmissionWeight(receiverAt(pixel, surface).lobes)));
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint word = texelFetch(layerTexture, pixel, 0).x;
    if (word == 0u) discard;
    color = vec4(texelFetch(radianceTexture, pixel, 0).rgb, unpackCoverage(word));
#ifdef REFRACTION
    seenThrough = uvec4(withSurface(pixel, word), word, floatBitsToUint(fetchDepth(pixel)));
#endif
}
