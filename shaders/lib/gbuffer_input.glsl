// Reads the G-buffer of the frame.

#include "shared/bindings.h"
#include "lib/gbuffer.glsl"

layout(binding = SURFACE_UNIT) uniform usampler2D surfaceTexture;
layout(binding = DEPTH_UNIT) uniform sampler2D depthTexture;
#ifdef LOBES
layout(binding = LOBES_UNIT) uniform usampler2D lobesTexture;
layout(binding = DIFFUSE_TRANSMISSION_UNIT) uniform usampler2D diffuseTransmissionTexture;
#endif

// Reversed depth; 0 on the background.
float fetchDepth(ivec2 pixel) {
    return texelFetch(depthTexture, pixel, 0).x;
}

GBufferWords fetchWords(ivec2 pixel) {
    GBufferWords words;
    words.surface = texelFetch(surfaceTexture, pixel, 0).xy;
#ifdef LOBES
    words.lobes = LobeWords(texelFetch(lobesTexture, pixel, 0), texelFetch(diffuseTransmissionTexture, pixel, 0).x);
#endif
    return words;
}

// False on the background and on unlit surfaces: the G-buffer stores nothing of them.
bool hasSurface(GBufferWords words) {
    return words.surface.y != 0u;
}

// Zeros where there is no surface.
GBufferSurface fetchSurfaceOrZero(ivec2 pixel) {
    GBufferWords words = fetchWords(pixel);
    if (hasSurface(words)) return unpackWords(words);
    GBufferSurface none = unpackWords(plainWords(uvec2(0u)));
    none.normal = vec3(0.0);
    return none;
}
