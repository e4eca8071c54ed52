// What the lighting passes read: surfaces of the G-buffer and light records, as the light equation takes them.
// BRDF is BRDF_COURSE or BRDF_GLTF, defined for each program that shades. SHADOWS is defined in frames with shadows.

#include "lib/frame.glsl"
#include "lib/gbuffer_input.glsl"
#include "shared/shading_constants.h"

layout(binding = LIGHTS_UNIT) uniform samplerBuffer lightRecords;
layout(binding = CONES_UNIT) uniform samplerBuffer coneRecords;
layout(binding = ALBEDO_UNIT) uniform sampler2D albedoTexture;

#define AlbedoTable sampler2D

float fastDivide(float a, float b) {
    return a / b;
}

#include "shared/shading.h"

AlbedoTexel readAlbedoTable(sampler2D table, float x, float y) {
    ivec2 last = textureSize(table, 0) - 1;
    vec2 texel = clamp(vec2(x, y), 0.0, 1.0) * vec2(last);
    ivec2 low = min(ivec2(texel), last - 1);
    vec2 weight = texel - vec2(low);
    vec2 a = mix(texelFetch(table, low, 0).rg, texelFetch(table, low + ivec2(1, 0), 0).rg, weight.x);
    vec2 b = mix(texelFetch(table, low + ivec2(0, 1), 0).rg, texelFetch(table, low + ivec2(1, 1), 0).rg, weight.x);
    vec2 value = mix(a, b, weight.y);
    return AlbedoTexel(value.x, value.y);
}
#ifdef SHADOWS
#include "lib/shadows.glsl"
#endif

LocalLight localLightOf(vec4 place, vec4 intensity) {
    return LocalLight(place.xyz, place.w, intensity.rgb);
}

LocalLight fetchLight(int index) {
    return localLightOf(texelFetch(lightRecords, index * LIGHT_TEXELS), texelFetch(lightRecords, index * LIGHT_TEXELS + 1));
}

LightCone lightConeOf(vec4 record) {
    return LightCone(record.xyz, record.w);
}

// The cone of a light of `fetchLight` that is a spot.
LightCone fetchCone(int index) {
    return lightConeOf(texelFetch(coneRecords, index - frame.lightCounts.x));
}

// Of the light of any type with this index.
bool castsShadow(int index) {
    return texelFetch(lightRecords, index * LIGHT_TEXELS + 1).w != 0.0;
}

// Is the point within the light's range?
bool isLit(vec3 position, LocalLight light) {
    vec3 d = light.position - position;
    return dot(d, d) * light.inverseRange2 < 1.0;
}

// A pixel of the G-buffer. `lit` is false on the background and on unlit surfaces, where `surface` and `position` are undefined but finite.
struct PixelSurface {
    bool lit;
    GBufferSurface surface;
    vec3 position;
#ifdef LOBES
    bool extended;  // else the members of `surface` are all
    ExtendedLobes lobes;
#endif
};

PixelSurface fetchSurface(ivec2 pixel) {
    PixelSurface result;
    GBufferWords words = fetchWords(pixel);
    float depth = fetchDepth(pixel);
    result.lit = hasSurface(words);
    result.surface = unpackWords(words);
#ifdef LOBES
    result.extended = hasExtendedLobes(words.lobes);
    result.lobes = unpackExtendedLobes(words.lobes, result.surface.normal);
#endif
    result.position = worldPosition(pixel, result.lit ? depth : 1.0);
    return result;
}

#ifdef SHADOWS
// Would the light shine on the surface if nothing were in between? No ray is traced where it would not.
bool isReached(ShadingPoint point, LocalLight light) {
    return isLit(point.position, light) && dot(point.normal, light.position - point.position) > 0.0;
}

bool isReached(ShadingPoint point, LocalLight light, LightCone cone) {
    return isReached(point, light) && coneRamp(cone, pathToLight(point, light).l) > 0.0;
}
#endif

#ifdef BRDF
// A pixel that lights shade.
struct Receiver {
    ShadingPoint point;
#ifdef SHADOWS
    vec3 rayEnd;  // of its occlusion rays
#endif
};

Receiver receiverAt(ivec2 at, PixelSurface pixel) {
    Receiver receiver;
    receiver.point =
        shadingPoint(BRDF, pixel.surface.lobes, pixel.surface.normal, pixel.position, wayToEye(pixel.position), albedoTexture);
#ifdef SHADOWS
    receiver.rayEnd = rayEndAt(at, pixel.position);
#endif
    return receiver;
}

vec3 pointLight(Receiver receiver, LocalLight light, bool hasShadow) {
#ifdef SHADOWS
    float passing = 1.0;
    if (hasShadow && isReached(receiver.point, light)) passing = transmittanceFromPoint(receiver.rayEnd, light.position);
    if (passing == 0.0) return vec3(0.0);
    return dimmed(pointLightRadiance(BRDF, receiver.point, light), passing);
#else
    return pointLightRadiance(BRDF, receiver.point, light);
#endif
}

vec3 spotLight(Receiver receiver, LocalLight light, LightCone cone, bool hasShadow) {
#ifdef SHADOWS
    float passing = 1.0;
    if (hasShadow && isReached(receiver.point, light, cone)) passing = transmittanceFromPoint(receiver.rayEnd, light.position);
    if (passing == 0.0) return vec3(0.0);
    return dimmed(spotLightRadiance(BRDF, receiver.point, light, cone), passing);
#else
    return spotLightRadiance(BRDF, receiver.point, light, cone);
#endif
}

vec3 directionalLight(Receiver receiver, int index) {
    vec3 l = texelFetch(lightRecords, index * LIGHT_TEXELS).xyz;
    vec3 irradiance = texelFetch(lightRecords, index * LIGHT_TEXELS + 1).rgb;
#ifdef SHADOWS
    float passing = 1.0;
    if (castsShadow(index) && dot(receiver.point.normal, l) > 0.0) passing = transmittanceFromDirection(receiver.rayEnd, l);
    if (passing == 0.0) return vec3(0.0);
    return dimmed(directionalLightRadiance(BRDF, receiver.point, l, irradiance), passing);
#else
    return directionalLightRadiance(BRDF, receiver.point, l, irradiance);
#endif
}
#endif
