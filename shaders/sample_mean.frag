// The sum of samples, from its two levels, over a number.

#include "shared/bindings.h"

layout(binding = SUM_UNIT) uniform sampler2D sumTexture;
layout(binding = LARGE_SUM_UNIT) uniform sampler2D largeSumTexture;
layout(location = SAMPLE_COUNT_LOCATION) uniform float count;

layout(location = 0) out vec4 mean;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    mean = (texelFetch(sumTexture, pixel, 0) + texelFetch(largeSumTexture, pixel, 0)) / count;
}
