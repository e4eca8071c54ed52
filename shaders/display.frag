// Radiance to code values: exposure, the display transform (appended to this text), and half a code value of dither.

#include "shared/bindings.h"

layout(binding = RADIANCE_UNIT) uniform sampler2D radianceTexture;
layout(location = EXPOSURE_LOCATION) uniform float exposure;
layout(location = ORIGIN_LOCATION) uniform ivec2 origin;  // the picture's lower left corner in the target
layout(location = PLACE_LOCATION) uniform ivec2 place;    // of a part of a larger picture: its lower left corner in it, for the dither

layout(location = 0) out vec4 code;

vec4 displayTransform(vec4 radiance);

// A hash of the pixel, 0 to 1, in integers so that every device computes the same. Source: Jarzynski and Olano, "Hash functions for
// GPU rendering", 2020 (pcg3d's multiplier and increment, folded to one dimension).
float pixelNoise(uvec2 pixel) {
    uint h = pixel.x * 1664525u + (pixel.y * 1664525u + 1013904223u) * 747796405u;
    h = (h ^ h >> 16) * 2246822519u;
    h = (h ^ h >> 13) * 3266489917u;
    return float((h ^ h >> 16) >> 8) * (1.0 / 16777216.0);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - origin;
    vec3 radiance = texelFetch(radianceTexture, pixel, 0).rgb;
    vec3 value = displayTransform(vec4(radiance * exposure, 1.0)).rgb;
    // Clamped, so that a value within 1/16 of a code, such as that of a texture, always becomes this code. The mean of all others is kept.
    float dither = clamp(pixelNoise(uvec2(pixel + place)) - 0.5, -7.0 / 16.0, 7.0 / 16.0) * (1.0 / 255.0);
    code = vec4(clamp(value + dither, 0.0, 1.0), 1.0);
}
