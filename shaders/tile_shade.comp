// Shades each pixel of a tile by the lights of its list: the G-buffer is read once and the radiance written once. LOAD_RADIANCE is 1
// where it adds to the radiance target, 0 where it overwrites it. It is no uniform: Mesa 22.3's zink keeps the compute variant
// of the first value.

#include "lib/lighting.glsl"
#include "lib/tiles.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = RADIANCE_IMAGE) uniform image2D radianceImage;
// The part of each list that this dispatch iterates over: listPart.y lights from listPart.x * listPart.y on.
layout(location = LIST_PART_LOCATION) uniform ivec2 listPart;

vec3 localLight(Receiver receiver, int index) {
    LocalLight light = fetchLight(index);
    if (!isLit(receiver.point.position, light)) return vec3(0.0);
    bool isPoint = index < frame.lightCounts.x;
#ifdef SHADOWS
    // One call, as each is compiled into the loop: transmittanceFromPoint is long.
    bool reached = isPoint ? isReached(receiver.pixel, light) : isReached(receiver.pixel, light, fetchCone(index));
    float passing = 1.0;
    if (reached && castsShadow(index)) passing = passingFrom(receiver, light);
    if (passing == 0.0) return vec3(0.0);
    if (isPoint) return dimmed(reflectedPoint(receiver, light), passing);
    return dimmed(reflectedSpot(receiver, light, fetchCone(index)), passing);
#else
    if (isPoint) return reflectedPoint(receiver, light);
    return reflectedSpot(receiver, light, fetchCone(index));
#endif
}

vec3 listedLights(Receiver receiver, int start, int first, int end) {
    vec3 sum = vec3(0.0);
    for (int i = first; i < end; ++i) sum += localLight(receiver, int(tileLists[start + i]));
    return sum;
}

vec3 allLocalLights(Receiver receiver, int first, int end) {
    vec3 sum = vec3(0.0);
    for (int i = first; i < end; ++i) sum += localLight(receiver, lightSpan.x + i);
    return sum;
}

vec3 directionalLights(Receiver receiver, int first, int end) {
    vec3 sum = vec3(0.0);
    int before = frame.lightCounts.x + frame.lightCounts.y;
    for (int i = first; i < end; ++i) sum += directionalLight(receiver, before + i);
    return sum;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint tile = gl_WorkGroupID.y * uint(tileGridSize().x) + gl_WorkGroupID.x;
    bool listed = isListed(tile);
    int count = listed ? int(tileCounts[tile]) : lightSpan.y - lightSpan.x;
    int first = listPart.x * listPart.y, end = min(first + listPart.y, count);
    // The first span brings the directional lights, in as many parts.
    int directionalEnd = min(first + listPart.y, lightSpan.x == 0 ? frame.lightCounts.z : 0);
    if (listPart.x > 0 && first >= max(end, directionalEnd)) return;
#if LOAD_RADIANCE
    vec3 radiance = imageLoad(radianceImage, pixel).rgb;
#else
    vec3 radiance = vec3(0.0);
#endif
    PixelSurface surface = fetchSurface(pixel);
    if (surface.lit) {
        Receiver receiver = receiverAt(pixel, surface);
        radiance += listed ? listedLights(receiver, int(tileStarts[tile]), first, end) : allLocalLights(receiver, first, end);
        radiance += directionalLights(receiver, first, directionalEnd);
    }
    imageStore(radianceImage, pixel, vec4(radiance, 0.0));
}
