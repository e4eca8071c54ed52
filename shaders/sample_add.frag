// What a frame adds to the sum of samples: its radiance, and in alpha how much of the pixel surfaces cover.

#include "shared/bindings.h"

layout(binding = RADIANCE_UNIT) uniform sampler2D radianceTexture;
layout(binding = DEPTH_UNIT) uniform sampler2D depthTexture;

layout(location = 0) out vec4 sum;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 radiance = texelFetch(radianceTexture, pixel, 0);
    // Alpha of the radiance is the coverage of the layers.
    sum = vec4(radiance.rgb, texelFetch(depthTexture, pixel, 0).x > 0.0 ? 1.0 : radiance.a);
}
