// Both reflection models in the merged form: with t = l + v neither the half vector nor its normalisation is built, and D, G and
// the denominator share one division. docs/lighting.md derives it; include/candela/brdf.h is the textbook form in double precision.
// BRDF is BRDF_COURSE or BRDF_GLTF, defined for each program.

#include "lib/albedo.glsl"
#include "lib/gbuffer.glsl"

#define BRDF_COURSE 0
#define BRDF_GLTF 1

const float PI = 3.14159265358979;
const float MIN_ALPHA = 1.0e-3;     // minAlpha of brdf.h
const float MIN_N_DOT_V = 1.0e-4;   // minNDotV
const float MAX_INVERSE_SQUARE = 1.0e6;  // 1 / minDistance²

// A surface with all that does not depend on the light.
struct ShadingPoint {
    vec3 position;
    vec3 normal;
    vec3 toEye;          // unit length
    float nDotV;         // of the true view direction, for the half vector; may be negative
    float alpha2;        // alpha²
    float lobe;          // what D G / (4 (n·l) (n·v)) has that does not depend on l
    vec2 masking;        // course: (1 - k, k); gltf: (n·v, its masking root)
    vec3 f0;
    vec3 diffuse;        // (1 - metallic) colour / pi
    vec3 compensation;   // factor on the specular lobe
};

ShadingPoint shadingPoint(GBufferSurface surface, vec3 position, vec3 eye) {
    ShadingPoint point;
    point.position = position;
    point.normal = surface.normal;
    point.toEye = normalize(eye - position);
    point.nDotV = dot(surface.normal, point.toEye);
    float alpha = max(surface.roughness * surface.roughness, MIN_ALPHA);
    float nDotV = max(point.nDotV, MIN_N_DOT_V);
    point.alpha2 = alpha * alpha;
    point.f0 = mix(vec3(0.04), surface.baseColor, surface.metallic);
    point.diffuse = surface.baseColor * ((1.0 - surface.metallic) / PI);
#if BRDF == BRDF_COURSE
    float k = (surface.roughness + 1.0) * (surface.roughness + 1.0) * 0.125;
    point.masking = vec2(1.0 - k, k);
    point.lobe = point.alpha2 / (4.0 * PI * (nDotV * (1.0 - k) + k));
    point.compensation = vec3(1.0);
#else
    point.masking = vec2(nDotV, sqrt(nDotV * nDotV * (1.0 - point.alpha2) + point.alpha2));
    point.lobe = point.alpha2 / (2.0 * PI);
    float albedo = directionalAlbedo(nDotV, alpha);
    point.compensation = 1.0 + point.f0 * ((1.0 - albedo) / albedo);
#endif
    return point;
}

// f(l, v) (n·l) for the unit vector l with nDotL = max(0, n·l).
vec3 reflectance(ShadingPoint point, vec3 l, float nDotL) {
    vec3 t = l + point.toEye;
    float nDotT = dot(point.normal, l) + point.nDotV;
    vec3 tangential = t - point.normal * nDotT;
    float tangential2 = dot(tangential, tangential);
    float t2 = tangential2 + nDotT * nDotT;
    // t² times GGX's (n·h)² (alpha² - 1) + 1, without its cancellation; the floor only guards l = -v, where t is 0.
    float q = max(tangential2 + point.alpha2 * nDotT * nDotT, 1.0e-15);
#if BRDF == BRDF_COURSE
    float masking = nDotL * point.masking.x + point.masking.y;
#else
    float masking = nDotL * point.masking.y +
                    point.masking.x * sqrt(nDotL * nDotL * (1.0 - point.alpha2) + point.alpha2);
#endif
    float specular = point.lobe * t2 * t2 / (q * q * masking);
    float grazing = max(1.0 - 0.5 * sqrt(t2), 0.0);  // 1 - v·h
    float grazing2 = grazing * grazing;
    vec3 fresnel = point.f0 + (1.0 - point.f0) * (grazing2 * grazing2 * grazing);
    return (point.diffuse * (1.0 - fresnel) + point.compensation * fresnel * specular) * nDotL;
}
