// Reads the G-buffer of the frame.

#include "shared/bindings.h"
#include "lib/gbuffer.glsl"

layout(binding = SURFACE_UNIT) uniform usampler2D surfaceTexture;
layout(binding = DEPTH_UNIT) uniform sampler2D depthTexture;

// Reversed depth; 0 on the background.
float fetchDepth(ivec2 pixel) {
    return texelFetch(depthTexture, pixel, 0).x;
}

GBufferWords fetchWords(ivec2 pixel) {
    return GBufferWords(texelFetch(surfaceTexture, pixel, 0).xy);
}

// False on the background and on unlit surfaces: the G-buffer stores nothing of them.
bool hasSurface(GBufferWords words) {
    return words.surface.y != 0u;
}

// Zeros where there is no surface.
GBufferSurface fetchSurfaceOrZero(ivec2 pixel) {
    GBufferWords words = fetchWords(pixel);
    if (hasSurface(words)) return unpackWords(words);
    GBufferSurface none = unpackWords(GBufferWords(uvec2(0u)));
    none.normal = vec3(0.0);
    return none;
}
