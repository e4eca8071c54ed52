// What the lighting passes read: surfaces of the G-buffer and light records, as the light equation takes them.
// BRDF is BRDF_COURSE or BRDF_GLTF, defined for each program that shades. SHADOWS is defined in frames with shadows, LOBES in those whose
// G-buffer has lobe words.

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
#ifdef LOBES
layout(binding = SHEEN_UNIT) uniform sampler2D sheenTexture;

bool anyAbove(float x) {
    return x > 0.0;
}

float whereAbove(float x, float a, float b) {
    return x > 0.0 ? a : b;
}

#include "shared/extended_lobes.h"
#endif
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

// Over 0 where the surface is lit from direction `d`, of any length.
float facing(PixelSurface pixel, vec3 d) {
#ifdef LOBES
    if (pixel.extended) {
        return facingOfLobes(pixel.surface.normal, pixel.lobes.clearcoat, pixel.lobes.clearcoatNormal, pixel.lobes.diffuseTransmission, d);
    }
#endif
    return dot(pixel.surface.normal, d);
}

#ifdef SHADOWS
// Would the light shine on the surface if nothing were in between? No ray is traced where it would not.
bool isReached(PixelSurface pixel, LocalLight light) {
    return isLit(pixel.position, light) && facing(pixel, light.position - pixel.position) > 0.0;
}

bool isReached(PixelSurface pixel, LocalLight light, LightCone cone) {
    ShadingPoint point;
    point.position = pixel.position;
    point.normal = pixel.surface.normal;
    return isReached(pixel, light) && coneRamp(cone, pathToLight(point, light).l) > 0.0;
}
#endif

#ifdef BRDF
// A pixel that lights shade.
struct Receiver {
    ShadingPoint point;
#ifdef LOBES
    ExtendedPoint lobes;  // where `pixel` is extended
#endif
#ifdef SHADOWS
    PixelSurface pixel;
    RayEnds rayEnds;  // of its occlusion rays
#elif defined(LOBES)
    PixelSurface pixel;
#endif
};

Receiver receiverAt(ivec2 at, PixelSurface pixel) {
    Receiver receiver;
#ifdef LOBES
    receiver.pixel = pixel;
    if (pixel.extended) {
        receiver.lobes = extendedPoint(BRDF, pixel.surface.lobes, pixel.lobes, pixel.surface.normal, pixel.position, wayToEye(pixel.position),
                                       albedoTexture, sheenTexture);
        receiver.point = receiver.lobes.base;
    } else
#endif
    {
        receiver.point =
            shadingPoint(BRDF, pixel.surface.lobes, pixel.surface.normal, pixel.position, wayToEye(pixel.position), albedoTexture);
    }
#ifdef SHADOWS
    receiver.pixel = pixel;
    receiver.rayEnds = rayEndsAt(at, pixel.position);
#endif
    return receiver;
}

// The radiance that leaves the surface by a light that nothing hides.
vec3 reflectedPoint(Receiver receiver, LocalLight light) {
#ifdef LOBES
    if (receiver.pixel.extended) return extendedPointLightRadiance(BRDF, receiver.lobes, light);
#endif
    return pointLightRadiance(BRDF, receiver.point, light);
}

vec3 reflectedSpot(Receiver receiver, LocalLight light, LightCone cone) {
#ifdef LOBES
    if (receiver.pixel.extended) return extendedSpotLightRadiance(BRDF, receiver.lobes, light, cone);
#endif
    return spotLightRadiance(BRDF, receiver.point, light, cone);
}

vec3 reflectedDirectional(Receiver receiver, vec3 l, vec3 illuminance) {
#ifdef LOBES
    if (receiver.pixel.extended) return extendedDirectionalLightRadiance(BRDF, receiver.lobes, l, illuminance);
#endif
    return directionalLightRadiance(BRDF, receiver.point, l, illuminance);
}

#ifdef SHADOWS
// Where the ray of a light in direction `d` ends: behind the surface where light passes from there.
vec3 rayEnd(Receiver receiver, vec3 d) {
#ifdef LOBES
    bool passes = receiver.pixel.extended && receiver.pixel.lobes.diffuseTransmission > 0.0;
    if (passes && dot(receiver.pixel.surface.normal, d) < 0.0 && dot(receiver.rayEnds.geometricNormal, d) < 0.0) return receiver.rayEnds.behind;
#endif
    return receiver.rayEnds.inFront;
}

// What passes of the light of a point or spot light that reaches the surface, 0 to 1.
float passingFrom(Receiver receiver, LocalLight light) {
    return transmittanceFromPoint(rayEnd(receiver, light.position - receiver.pixel.position), light.position);
}
#endif

vec3 pointLight(Receiver receiver, LocalLight light, bool hasShadow) {
#ifdef SHADOWS
    float passing = 1.0;
    if (hasShadow && isReached(receiver.pixel, light)) passing = passingFrom(receiver, light);
    if (passing == 0.0) return vec3(0.0);
    return dimmed(reflectedPoint(receiver, light), passing);
#else
    return reflectedPoint(receiver, light);
#endif
}

vec3 spotLight(Receiver receiver, LocalLight light, LightCone cone, bool hasShadow) {
#ifdef SHADOWS
    float passing = 1.0;
    if (hasShadow && isReached(receiver.pixel, light, cone)) passing = passingFrom(receiver, light);
    if (passing == 0.0) return vec3(0.0);
    return dimmed(reflectedSpot(receiver, light, cone), passing);
#else
    return reflectedSpot(receiver, light, cone);
#endif
}

vec3 directionalLight(Receiver receiver, int index) {
    vec3 l = texelFetch(lightRecords, index * LIGHT_TEXELS).xyz;
    vec3 irradiance = texelFetch(lightRecords, index * LIGHT_TEXELS + 1).rgb;
#ifdef SHADOWS
    float passing = 1.0;
    if (castsShadow(index) && facing(receiver.pixel, l) > 0.0) passing = transmittanceFromDirection(rayEnd(receiver, l), l);
    if (passing == 0.0) return vec3(0.0);
    return dimmed(reflectedDirectional(receiver, l, irradiance), passing);
#else
    return reflectedDirectional(receiver, l, irradiance);
#endif
}
#endif
