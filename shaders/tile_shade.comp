// Shades each pixel of a tile by the lights of its list: the G-buffer is read once and the radiance written once. LOAD_RADIANCE is 1
// where it adds to the radiance target, 0 where it overwrites it. It is no uniform: Mesa 22.3's zink keeps the compute variant
// of the first value.

#include "lib/lighting.glsl"
#include "lib/tiles.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = RADIANCE_IMAGE) uniform image2D radianceImage;
// The part of each list that this dispatch iterates over: LIST_PART lights from part * LIST_PART on.
layout(location = LIST_PART_LOCATION) uniform int part;

vec3 localLight(ShadingPoint point, int index) {
    LocalLight light = fetchLight(index);
    if (!isLit(point.position, light)) return vec3(0.0);
    if (index < frame.lightCounts.x) return pointLightRadiance(BRDF, point, light);
    return spotLightRadiance(BRDF, point, light, fetchCone(index));
}

vec3 listedLights(ShadingPoint point, int start, int first, int end) {
    vec3 sum = vec3(0.0);
    for (int i = first; i < end; ++i) sum += localLight(point, int(tileLists[start + i]));
    return sum;
}

vec3 allLocalLights(ShadingPoint point, int first, int end) {
    vec3 sum = vec3(0.0);
    for (int i = first; i < end; ++i) sum += localLight(point, lightSpan.x + i);
    return sum;
}

vec3 directionalLights(ShadingPoint point) {
    vec3 sum = vec3(0.0);
    int first = frame.lightCounts.x + frame.lightCounts.y;
    for (int i = first; i < first + frame.lightCounts.z; ++i) sum += directionalLight(point, i);
    return sum;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint tile = gl_WorkGroupID.y * uint(tileGridSize().x) + gl_WorkGroupID.x;
    bool listed = isListed(tile);
    int count = listed ? int(tileCounts[tile]) : lightSpan.y - lightSpan.x;
    int first = part * LIST_PART, end = min(first + LIST_PART, count);
    if (part > 0 && first >= end) return;
#if LOAD_RADIANCE
    vec3 radiance = imageLoad(radianceImage, pixel).rgb;
#else
    vec3 radiance = vec3(0.0);
#endif
    PixelSurface surface = fetchSurface(pixel);
    if (surface.lit) {
        ShadingPoint point = shadingPointOf(surface);
        radiance += listed ? listedLights(point, int(tileStarts[tile]), first, end) : allLocalLights(point, first, end);
        if (part == 0 && lightSpan.x == 0) radiance += directionalLights(point);
    }
    imageStore(radianceImage, pixel, vec4(radiance, 0.0));
}
