// A data view: one channel of the frame as the display's code values. SHOW names the view, defined for each program.

#include "lib/frame.glsl"
#include "lib/gbuffer.glsl"
#include "lib/max_reduction.glsl"

#define SHOW_NORMALS 0
#define SHOW_LEVEL 1
#define SHOW_BASE_COLOR 2
#define SHOW_METALLIC 3
#define SHOW_ROUGHNESS 4
#define SHOW_DEPTH 5
#define SHOW_EMISSION 6
#define SHOW_LIGHT_COUNT 7

layout(binding = SURFACE_UNIT) uniform usampler2D surfaceTexture;
layout(binding = DEPTH_UNIT) uniform sampler2D depthTexture;

layout(location = 0) out vec4 code;

#if SHOW == SHOW_LEVEL
layout(binding = SHOWN_UNIT) uniform usampler2D instanceTexture;  // instance + 1, 0 where there is none
layout(binding = INSTANCE_COLORS_UNIT) uniform samplerBuffer instanceColors;

vec3 codeOf(ivec2 pixel) {
    uint instance = texelFetch(instanceTexture, pixel, 0).x;
    return instance > 0u ? texelFetch(instanceColors, int(instance) - 1).rgb : vec3(0.0);
}

#elif SHOW == SHOW_DEPTH
// Of d = near plane / distance: near / (near + distance) = d / (d + greatest d).
vec3 codeOf(ivec2 pixel) {
    float depth = texelFetch(depthTexture, pixel, 0).x;
    return vec3(depth / (depth + uintBitsToFloat(greatest)));
}

#elif SHOW == SHOW_EMISSION
// The target that this is written to: each pixel is read only where it is then written.
layout(binding = SHOWN_UNIT) uniform sampler2D radianceTexture;

vec3 codeOf(ivec2 pixel) { return srgbEncode(clamp(texelFetch(radianceTexture, pixel, 0).rgb, 0.0, 1.0)); }

#elif SHOW == SHOW_LIGHT_COUNT
layout(binding = SHOWN_UNIT) uniform sampler2D countTexture;
layout(location = HEAT_STOPS_LOCATION) uniform vec3 heatStops[HEAT_STOPS];

vec3 heatColor(float share) {
    float position = clamp(share, 0.0, 1.0) * float(HEAT_STOPS - 1);
    int step_ = min(int(position), HEAT_STOPS - 2);
    return mix(heatStops[step_], heatStops[step_ + 1], position - float(step_));
}

vec3 codeOf(ivec2 pixel) {
    return heatColor(texelFetch(countTexture, pixel, 0).x / max(uintBitsToFloat(greatest), 1.0));
}

#else
// Unlit surfaces keep none of these channels: zeros stand for them, as in the AOVs.
vec3 codeOf(ivec2 pixel) {
    uvec2 texel = texelFetch(surfaceTexture, pixel, 0).xy;
    GBufferSurface surface = unpackSurface(texel);
    if (texel.y == 0u) surface = GBufferSurface(vec3(0.0), SurfaceLobes(vec3(0.0), 0.0, 0.0));
#if SHOW == SHOW_NORMALS
    return 0.5 + 0.5 * surface.normal;
#elif SHOW == SHOW_BASE_COLOR
    return srgbEncode(surface.lobes.baseColor);
#elif SHOW == SHOW_METALLIC
    return vec3(surface.lobes.metallic);
#else
    return vec3(surface.lobes.roughness);
#endif
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool isSurface = texelFetch(depthTexture, pixel, 0).x > 0.0;
    code = vec4(isSurface ? codeOf(pixel) : vec3(0.0), 0.0);
}
