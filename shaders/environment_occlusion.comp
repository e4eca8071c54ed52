// How much of the environment each pixel sees. FILTER 0 traces rays of each pixel and sums what does not arrive; FILTER 1 averages over a window
// of pixels. OCCLUSION is defined where the G-buffer has what occlusion textures leave. lib/render/occlusion/environment_occlusion.cpp does the
// same.

#include "lib/gbuffer_input.glsl"
#include "lib/shadows.glsl"
#include "shared/environment_ray.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(location = ENVIRONMENT_RAYS_LOCATION) uniform uvec4 rays;
layout(location = ENVIRONMENT_DISTANCE_LOCATION) uniform float maxDistance;

layout(r32f, binding = HIDDEN_IMAGE) uniform image2D hiddenImage;

#if FILTER == 0
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, frame.size.xy))) return;
    GBufferWords words = fetchWords(at);
    if (!hasSurface(words)) return;
    vec3 position = worldPosition(at, fetchDepth(at)), normal = unpackNormal(words.surface.y);
    ShadowSurface surface = unpackShadowWord(texelFetch(shadowTexture, at, 0).x);
    vec3 from = shadowRayEnd(position, wayToEye(position), surface.geometricNormal, surface.lift, pixelExtent(position));
    TangentPair tangents = tangentsOf(normal);
    uint first = firstEnvironmentRay(uint(at.x), uint(at.y), rays.w, rays.z);
    float hidden = rays.x == 0u ? 0.0 : imageLoad(hiddenImage, at).x;
    for (uint ray = rays.x; ray < rays.y; ++ray) {
        vec3 direction = environmentDirection(first + ray);
        vec3 way = direction.x * tangents.first + direction.y * tangents.second + direction.z * normal;
        hidden += 1.0 - transmittance(from, aboveTriangle(way, surface.geometricNormal), 0.0, maxDistance);
    }
    imageStore(hiddenImage, at, vec4(hidden));
}
#else
layout(r8, binding = VISIBILITY_IMAGE) writeonly uniform image2D visibilityImage;
#ifdef OCCLUSION
layout(binding = ENVIRONMENT_VISIBILITY_UNIT) uniform sampler2D occlusionTexture;
#endif

vec3 geometricNormalAt(ivec2 at) {
    return unpackShadowWord(texelFetch(shadowTexture, at, 0).x).geometricNormal;
}

// The mean over the pixels of a window of the pattern's size that lie on the surface of this pixel.
float hiddenAt(ivec2 at) {
    vec3 position = worldPosition(at, fetchDepth(at)), normal = geometricNormalAt(at);
    float extent = pixelExtent(position), sum = 0.0, weight = 0.0;
    ivec2 start = at + ivec2(filterStart(rays.w, 0), filterStart(rays.w, 1));
    ivec2 low = max(start, ivec2(0)), high = min(start + OCCLUSION_PATTERN, frame.size.xy) - 1;
    for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) {
            ivec2 other = ivec2(x, y);
            if (!hasSurface(fetchWords(other))) continue;
            float distance = dot(normal, worldPosition(other, fetchDepth(other)) - position);
            if (!isFiltered(distance, dot(normal, geometricNormalAt(other)), extent)) continue;
            sum += imageLoad(hiddenImage, other).x;
            weight += 1.0;
        }
    }
    return weight > 0.0 ? sum / weight : imageLoad(hiddenImage, at).x;
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, frame.size.xy))) return;
    if (!hasSurface(fetchWords(at))) {
        imageStore(visibilityImage, at, vec4(0.0));
        return;
    }
    float visibility = 1.0 - hiddenAt(at) / float(rays.z);
#ifdef OCCLUSION
    visibility *= texelFetch(occlusionTexture, at, 0).r;
#endif
    imageStore(visibilityImage, at, vec4(visibility));
}
#endif
