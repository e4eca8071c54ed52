// Every light of a span at every pixel: the reference technique, and directional lights for all techniques.

#include "lib/lighting.glsl"

layout(location = LIGHT_SPANS_LOCATION) uniform ivec4 localLights;        // points: first, end; spots: first, end
layout(location = DIRECTIONAL_SPAN_LOCATION) uniform ivec2 directionals;  // first, end

layout(location = 0) out vec4 radiance;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    PixelSurface pixel = fetchSurface(at);
    if (!pixel.lit) discard;
    Receiver receiver = receiverAt(at, pixel);
    vec3 sum = vec3(0.0);
    for (int i = localLights.x; i < localLights.y; ++i) sum += pointLight(receiver, fetchLight(i), castsShadow(i));
    for (int i = localLights.z; i < localLights.w; ++i) sum += spotLight(receiver, fetchLight(i), fetchCone(i), castsShadow(i));
    for (int i = directionals.x; i < directionals.y; ++i) sum += directionalLight(receiver, i);
    radiance = vec4(sum, 0.0);
}
