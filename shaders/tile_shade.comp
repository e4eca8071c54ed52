// Shades each pixel of a tile by the lights of its list: the G-buffer is read once and the radiance written once.

#include "lib/tiles.glsl"
#include "lib/surface.glsl"
#include "lib/lights.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = RADIANCE_IMAGE) uniform image2D radianceImage;
layout(location = KEEPS_EMISSION_LOCATION) uniform bool keepsEmission;
// Which part of each list this dispatch walks: LIST_PART lights from part * LIST_PART on. The first part starts the sum, the others add to it.
layout(location = LIST_PART_LOCATION) uniform int part;

vec3 localLight(ShadingPoint point, int index) {
    LocalLight light = fetchLight(index);
    if (!isLit(point, light)) return vec3(0.0);
    if (index < frame.lightCounts.x) return pointLight(point, light, 1.0);
    return spotLight(point, light, texelFetch(coneRecords, index - frame.lightCounts.x));
}

vec3 listedLights(ShadingPoint point, int start, int first, int end) {
    vec3 sum = vec3(0.0);
    for (int i = first; i < end; ++i) sum += localLight(point, int(tileLists[start + i]));
    return sum;
}

vec3 allLocalLights(ShadingPoint point, int first, int end) {
    vec3 sum = vec3(0.0);
    for (int i = first; i < end; ++i) sum += localLight(point, i);
    return sum;
}

vec3 directionalLights(ShadingPoint point) {
    vec3 sum = vec3(0.0);
    int first = frame.lightCounts.x + frame.lightCounts.y;
    for (int i = first; i < first + frame.lightCounts.z; ++i) {
        sum += directionalLight(point, texelFetch(lightRecords, i * LIGHT_TEXELS).xyz,
                                texelFetch(lightRecords, i * LIGHT_TEXELS + 1).rgb);
    }
    return sum;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint tile = gl_WorkGroupID.y * uint(tileGrid().x) + gl_WorkGroupID.x;
    bool listed = isListed(tile);
    int count = listed ? int(tileCounts[tile]) : frame.lightCounts.x + frame.lightCounts.y;
    int first = part * LIST_PART, end = min(first + LIST_PART, count);
    if (part > 0 && first >= end) return;
    vec3 radiance = keepsEmission || part > 0 ? imageLoad(radianceImage, pixel).rgb : vec3(0.0);
    ShadingPoint point;
    if (fetchShadingPoint(pixel, point)) {
        radiance += listed ? listedLights(point, int(tileStarts[tile]), first, end) : allLocalLights(point, first, end);
        if (part == 0) radiance += directionalLights(point);
    }
    imageStore(radianceImage, pixel, vec4(radiance, 0.0));
}
