// Marks the layers that share a depth with the next one at some pixel: a bit each, from the second word on.

#include "shared/bindings.h"

layout(binding = LAYER_DEPTHS_UNIT) uniform usampler2DArray fragmentDepths;
layout(binding = DEPTH_TIES_IMAGE, r32ui) uniform uimage2D depthTies;

void main() {
    int length = textureSize(fragmentDepths, 0).z;
    uint depth = texelFetch(fragmentDepths, ivec3(ivec2(gl_FragCoord.xy), 0), 0).x;
    for (int i = 1; i < length && depth != 0u; ++i) {
        uint next = texelFetch(fragmentDepths, ivec3(ivec2(gl_FragCoord.xy), i), 0).x;
        if (next == depth) imageAtomicOr(depthTies, ivec2(1 + (i - 1) / 32, 0), 1u << uint((i - 1) % 32));
        depth = next;
    }
}
