// Every light of a span at every pixel: the reference technique, and directional lights for all techniques.

#include "lib/surface.glsl"
#include "lib/lights.glsl"

layout(location = LIGHT_RANGES_LOCATION) uniform ivec4 localLights;     // points: first, end; spots: first, end
layout(location = DIRECTIONALS_LOCATION) uniform ivec2 directionals;    // first, end

layout(location = 0) out vec4 radiance;

void main() {
    ShadingPoint point;
    if (!fetchShadingPoint(ivec2(gl_FragCoord.xy), point)) discard;
    vec3 sum = vec3(0.0);
    for (int i = localLights.x; i < localLights.y; ++i) sum += pointLight(point, fetchLight(i), 1.0);
    for (int i = localLights.z; i < localLights.w; ++i) {
        sum += spotLight(point, fetchLight(i), texelFetch(coneRecords, i - frame.lightCounts.x));
    }
    for (int i = directionals.x; i < directionals.y; ++i) {
        sum += directionalLight(point, texelFetch(lightRecords, i * LIGHT_TEXELS).xyz,
                                texelFetch(lightRecords, i * LIGHT_TEXELS + 1).rgb);
    }
    radiance = vec4(sum, 0.0);
}
