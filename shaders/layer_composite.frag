// A layer of transparent surfaces; blending lays it over what is behind. With REFRACTION it brings what is seen through it: with BLURRED also
// blurred, with DISPERSED also at places that differ by colour.

#include "lib/frame.glsl"
#include "lib/gbuffer.glsl"

layout(binding = LAYER_COLOR_UNIT) uniform sampler2D layerTexture;

layout(location = 0) out vec4 color;

#ifdef REFRACTION
layout(binding = LAYER_REFRACTION_UNIT) uniform usampler2D seenThroughTexture;  // as layer_store.frag writes it
layout(binding = BEHIND_UNIT) uniform sampler2D behindTexture;
layout(binding = OPAQUE_DEPTH_UNIT) uniform sampler2D opaqueDepth;

vec3 behindPixel(ivec2 pixel) {
    return texelFetch(behindTexture, clamp(pixel, ivec2(0), frame.size.xy - 1), 0).rgb;
}

// Between the four pixels around a place.
vec3 sharpBehind(vec2 place) {
    ivec2 low = ivec2(floor(place - 0.5));
    vec2 weight = place - 0.5 - vec2(low);
    vec3 below = mix(behindPixel(low), behindPixel(low + ivec2(1, 0)), weight.x);
    vec3 above = mix(behindPixel(low + ivec2(0, 1)), behindPixel(low + ivec2(1, 1)), weight.x);
    return mix(below, above, weight.y);
}

#ifdef BLURRED
// A level by cubic B-splines, of four texels along each axis. Sigg and Hadwiger, "Fast third-order texture filtering", GPU Gems 2, 2005.
vec3 smoothLevel(vec2 place, int level) {
    vec2 size = vec2(textureSize(behindTexture, level));
    vec2 texel = place / vec2(frame.size.xy) * size - 0.5, low = floor(texel), t = texel - low, s = 1.0 - t;
    vec2 first = s * s * s / 6.0, last = t * t * t / 6.0;
    vec2 second = 2.0 / 3.0 - 0.5 * t * t * (2.0 - t), third = 1.0 - first - second - last;
    vec2 left = first + second, right = third + last;
    vec2 from = (low - 0.5 + second / left) / size, to = (low + 1.5 + last / right) / size;
    vec3 below = left.x * textureLod(behindTexture, from, level).rgb + right.x * textureLod(behindTexture, vec2(to.x, from.y), level).rgb;
    vec3 above = left.x * textureLod(behindTexture, vec2(from.x, to.y), level).rgb + right.x * textureLod(behindTexture, to, level).rgb;
    return left.y * below + right.y * above;
}
#endif

vec3 behindAt(vec2 place, float level) {
#ifdef BLURRED
    if (level <= 0.0) return sharpBehind(place);
    int low = int(level);
    vec3 fine = low == 0 ? sharpBehind(place) : smoothLevel(place, low);
    return mix(fine, smoothLevel(place, low + 1), level - float(low));
#else
    return sharpBehind(place);
#endif
}

// The place from which light comes, unless an opaque surface in front of the layer is there.
vec2 placeAt(vec2 offset, float depth) {
    vec2 place = gl_FragCoord.xy + offset;
    ivec2 pixel = clamp(ivec2(floor(place)), ivec2(0), frame.size.xy - 1);
    return texelFetch(opaqueDepth, pixel, 0).x > depth ? gl_FragCoord.xy : place;
}

vec3 refracted(Refraction refraction, float depth) {
    float levels = log2(float(max(frame.size.x, frame.size.y)));
    float level = min(refraction.blur * levels, levels - 1.0);
    vec3 middle = behindAt(placeAt(refraction.offset, depth), level);
#ifdef DISPERSED
    vec3 red = behindAt(placeAt(refraction.offset * (1.0 - refraction.spread), depth), level);
    vec3 blue = behindAt(placeAt(refraction.offset * (1.0 + refraction.spread), depth), level);
    return vec3(red.r, middle.g, blue.b);
#else
    return middle;
#endif
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    color = texelFetch(layerTexture, pixel, 0);
    if (color.a == 0.0) discard;
#ifdef REFRACTION
    uvec4 words = texelFetch(seenThroughTexture, pixel, 0);
    Refraction refraction = unpackRefraction(words.z, words.xy);
    if (words.y != 0u) color.rgb += refraction.transmittance * refracted(refraction, uintBitsToFloat(words.w));
#endif
}
