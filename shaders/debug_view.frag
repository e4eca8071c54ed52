// A debug view: the display's code values of one quantity of the frame. Each program defines SOURCE, where the quantity comes from, and
// VIEW_CODE, the code values as an expression over the variables that `viewCode` declares (see lib/render/gbuffer/channels.cpp).

#include "lib/frame.glsl"
#include "lib/gbuffer_input.glsl"
#include "lib/max_reduction.glsl"

#define SOURCE_DEPTH 0
#define SOURCE_SURFACE 1
#define SOURCE_EMISSION 2
#define SOURCE_COUNT 3
#define SOURCE_INSTANCE 4

#if SOURCE == SOURCE_EMISSION
layout(binding = VIEW_UNIT) uniform sampler2D emissionTexture;

#elif SOURCE == SOURCE_COUNT
layout(binding = VIEW_UNIT) uniform sampler2D countTexture;
layout(location = HEAT_STOPS_LOCATION) uniform vec3 heatStops[HEAT_STOPS];

vec3 heatColor(float share) {
    float position = clamp(share, 0.0, 1.0) * float(HEAT_STOPS - 1);
    int first = min(int(position), HEAT_STOPS - 2);
    return mix(heatStops[first], heatStops[first + 1], position - float(first));
}

#elif SOURCE == SOURCE_INSTANCE
layout(binding = VIEW_UNIT) uniform usampler2D instanceTexture;  // instance + 1, 0 where there is none
layout(binding = INSTANCE_COLORS_UNIT) uniform samplerBuffer instanceColors;
#endif

layout(location = 0) out vec4 code;

// Nearest / (nearest + distance), where the closest surface has the largest depth.
float depthCode(float depth, float largest) {
    if (!isOrthographic()) {
        vec2 inverse = vec2(depth, largest) * frame.depthRange.y + frame.depthRange.x;
        return inverse.x / (inverse.x + inverse.y);
    }
    float nearest = viewDistance(largest), distance = viewDistance(depth);
    return distance > 0.0 ? nearest / (nearest + distance) : 0.5;
}

vec3 viewCode(ivec2 pixel, float depth) {
    float maximum = uintBitsToFloat(maximumBits);
#if SOURCE == SOURCE_SURFACE
    GBufferSurface surface = fetchSurfaceOrZero(pixel);
#elif SOURCE == SOURCE_EMISSION
    vec3 emission = texelFetch(emissionTexture, pixel, 0).rgb;
#elif SOURCE == SOURCE_COUNT
    float count = texelFetch(countTexture, pixel, 0).x;
#elif SOURCE == SOURCE_INSTANCE
    uint instance = texelFetch(instanceTexture, pixel, 0).x;
    vec3 instanceColor = instance > 0u ? texelFetch(instanceColors, int(instance) - 1).rgb : vec3(0.0);
#endif
    return VIEW_CODE;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = fetchDepth(pixel);
    code = vec4(depth > 0.0 ? viewCode(pixel, depth) : vec3(0.0), 0.0);
}
