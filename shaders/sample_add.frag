// What a frame adds to the sum of samples: its radiance, and in alpha 1 where a surface covers the pixel.

#include "shared/bindings.h"

layout(binding = RADIANCE_UNIT) uniform sampler2D radianceTexture;
layout(binding = DEPTH_UNIT) uniform sampler2D depthTexture;

layout(location = 0) out vec4 sum;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float coverage = texelFetch(depthTexture, pixel, 0).x > 0.0 ? 1.0 : 0.0;
    sum = vec4(texelFetch(radianceTexture, pixel, 0).rgb, coverage);
}
