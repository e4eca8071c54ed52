// The maps of the frame's environment. Follows lib/lighting.glsl.

layout(binding = ENVIRONMENT_UNIT) uniform samplerBuffer environmentTexels;

float signOf(float x) {
    return x < 0.0 ? -1.0 : 1.0;
}

float octavesBelowOne(float x) {
    return float(floatBitsToInt(1.0) - floatBitsToInt(x)) * (1.0 / 8388608.0);
}

#include "shared/environment.h"

vec3 fetchTexel(int index) {
    return texelFetch(environmentTexels, index).rgb;
}

// The map that texel `header` describes, between its four texels around a point.
vec3 interpolatedMap(int header, MapPoint point) {
    ivec2 map = ivec2(fetchTexel(header).xy);
    vec2 position = clamp(vec2(point.u, point.v), 0.0, 1.0) * float(map.y - 1);
    ivec2 low = min(ivec2(position), map.y - 2);
    vec2 weight = position - vec2(low);
    int stride = map.y, at = map.x + low.y * stride + low.x;
    return mix(mix(fetchTexel(at), fetchTexel(at + 1), weight.x), mix(fetchTexel(at + stride), fetchTexel(at + stride + 1), weight.x),
               weight.y);
}

EnvironmentAxes environmentAxes() {
    return EnvironmentAxes(frame.environmentX.xyz, frame.environmentY.xyz, frame.environmentZ.xyz);
}

float environmentIntensity() {
    return frame.environmentX.w;
}

// Of a normal in the picture's frame, without the intensity.
vec3 irradianceAt(vec3 normal) {
    vec3 sum = interpolatedMap(ENVIRONMENT_IRRADIANCE, octahedralPoint(normal));
    int peaks = int(fetchTexel(ENVIRONMENT_PEAK_COUNT).x);
    for (int i = 0; i < peaks; ++i) {
        int at = ENVIRONMENT_PEAKS + 2 * i;
        vec4 peak = texelFetch(environmentTexels, at);
        sum += fetchTexel(at + 1) * meanCosine(dot(normal, peak.xyz), peak.w);
    }
    return sum;
}

// What a lobe gathers around a direction in the picture's frame, without the intensity.
vec3 radianceAt(vec3 direction, float level) {
    MapPoint point = octahedralPoint(direction);
    float kept = min(level, float(ENVIRONMENT_LEVELS - 1));
    int low = min(int(kept), ENVIRONMENT_LEVELS - 2);
    return mix(interpolatedMap(low, point), interpolatedMap(low + 1, point), kept - float(low));
}
