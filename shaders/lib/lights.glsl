// The light records and the radiance that each kind of light adds.

#include "lib/brdf.glsl"
#include "shared/bindings.h"

layout(binding = LIGHTS_UNIT) uniform samplerBuffer lightRecords;
layout(binding = CONES_UNIT) uniform samplerBuffer coneRecords;

struct LocalLight {
    vec3 position;
    float inverseRange2;  // 1 / range²
    vec3 intensity;       // colour × candela, in the working space
};

LocalLight fetchLight(int index) {
    vec4 place = texelFetch(lightRecords, index * LIGHT_TEXELS);
    return LocalLight(place.xyz, place.w, texelFetch(lightRecords, index * LIGHT_TEXELS + 1).rgb);
}

// Is the point within the light's range?
bool isLit(ShadingPoint point, LocalLight light) {
    vec3 d = light.position - point.position;
    return dot(d, d) * light.inverseRange2 < 1.0;
}

// Radiance by a point light, times `attenuation`. The window is KHR_lights_punctual's.
vec3 pointLight(ShadingPoint point, LocalLight light, float attenuation) {
    vec3 d = light.position - point.position;
    float d2 = dot(d, d);
    float relative2 = d2 * light.inverseRange2;
    float window = max(1.0 - relative2 * relative2, 0.0);
    float inverse = inversesqrt(max(d2, 1.0e-24));
    vec3 l = d * inverse;
    float nDotL = max(dot(point.normal, l), 0.0);
    float scale = attenuation * window * min(inverse * inverse, MAX_INVERSE_SQUARE);
    return reflectance(point, l, nDotL) * (light.intensity * scale);
}

// `cone` holds the direction times the ramp's scale, and the ramp's offset.
float spotFactor(vec3 toPoint, vec4 cone) {
    float ramp = clamp(dot(normalize(toPoint), cone.xyz) + cone.w, 0.0, 1.0);
    return ramp * ramp;
}

vec3 spotLight(ShadingPoint point, LocalLight light, vec4 cone) {
    vec3 toPoint = point.position - light.position;
    return pointLight(point, light, dot(toPoint, toPoint) > 0.0 ? spotFactor(toPoint, cone) : 0.0);
}

// A directional light's record: the direction towards it, and its illuminance.
vec3 directionalLight(ShadingPoint point, vec3 l, vec3 illuminance) {
    return reflectance(point, l, max(dot(point.normal, l), 0.0)) * illuminance;
}
