// Reads the surface of a pixel for the lighting passes.

#include "lib/frame.glsl"
#include "lib/brdf.glsl"

layout(binding = SURFACE_UNIT) uniform usampler2D surfaceTexture;
layout(binding = DEPTH_UNIT) uniform sampler2D depthTexture;

// No light falls where this is false: on the background and on unlit surfaces.
bool fetchShadingPoint(ivec2 pixel, out ShadingPoint point) {
    uvec2 texel = texelFetch(surfaceTexture, pixel, 0).xy;
    float depth = texelFetch(depthTexture, pixel, 0).x;
    bool lit = texel.y != 0u;
    point = shadingPoint(unpackSurface(texel), worldPosition(pixel, lit ? depth : 1.0), frame.eye.xyz);
    return lit;
}
