// Every light of a span at every pixel: the reference technique, and directional lights for all techniques.

#include "lib/lighting.glsl"

layout(location = LIGHT_SPANS_LOCATION) uniform ivec4 localLights;        // points: first, end; spots: first, end
layout(location = DIRECTIONAL_SPAN_LOCATION) uniform ivec2 directionals;  // first, end

layout(location = 0) out vec4 radiance;

void main() {
    PixelSurface pixel = fetchSurface(ivec2(gl_FragCoord.xy));
    if (!pixel.lit) discard;
    ShadingPoint point = shadingPointOf(pixel);
    vec3 sum = vec3(0.0);
    for (int i = localLights.x; i < localLights.y; ++i) sum += pointLightRadiance(BRDF, point, fetchLight(i));
    for (int i = localLights.z; i < localLights.w; ++i) sum += spotLightRadiance(BRDF, point, fetchLight(i), fetchCone(i));
    for (int i = directionals.x; i < directionals.y; ++i) sum += directionalLight(point, i);
    radiance = vec4(sum, 0.0);
}
