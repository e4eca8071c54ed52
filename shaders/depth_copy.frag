// Copies depth into a buffer that has stencil too.

#include "shared/bindings.h"

layout(binding = DEPTH_UNIT) uniform sampler2D depthTexture;

void main() {
    gl_FragDepth = texelFetch(depthTexture, ivec2(gl_FragCoord.xy), 0).x;
}
