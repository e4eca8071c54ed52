// What the geometry pass writes of a surface.

#include "shared/bindings.h"
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"
#include "shared/shading_constants.h"

layout(location = SURFACE_OUTPUT) out uvec2 surfaceWords;
#ifdef LOBES
layout(location = LOBES_OUTPUT) out uvec4 lobeWords;
layout(location = DIFFUSE_TRANSMISSION_OUTPUT) out uint diffuseTransmissionWord;
#endif
#ifdef SHADOWS
layout(location = SHADOW_OUTPUT) out uint shadowWord;

// The height of the smooth surface that the vertex normals describe over the triangle: the mean, weighted by barycentric coordinates, of
// the heights of the tangent planes at the vertices (Hanika, "Hacking the shadow terminator", Ray Tracing Gems II, 2021, and before it
// Boubekeur and Alexa, "Phong tessellation", 2008). `position` is relative to the eye; `normal` and `tangentPlane` are the vertex
// normal and its product with the vertex position, both interpolated.
void writeShadowWord(vec3 position, vec3 normal, float tangentPlane) {
    // Beside the horizon of a plane, a derivative may reach to a pixel beyond it, where the plane goes on behind the eye: the cross product
    // is still normal to the plane, but its sign says nothing.
    vec3 geometricNormal = cross(dFdx(position), dFdy(position));
    vec3 way = isOrthographic() ? -frame.cameraForward.xyz : -position;
    if (dot(geometricNormal, way) < 0.0) geometricNormal = -geometricNormal;
    float height = tangentPlane - dot(normal, position);
    shadowWord = packShadowWord(geometricNormal, dot(normal, geometricNormal) < 0.0 ? -height : height);
}
#endif

#ifdef OCCLUSION
layout(location = OCCLUSION_OUTPUT) out float environmentShare;
#endif

// `red` is that of the occlusion texture (glTF 2.0, 3.9.3).
void writeOcclusion(float red, float strength) {
#ifdef OCCLUSION
    environmentShare = 1.0 + strength * (red - 1.0);
#endif
}

// What the normals within the pixel add to alpha², by the screen-space derivatives of `normal`, which has any length. Kaplanyan, Hill, Patney
// and Lefohn, "Filtering distributions of normals for shading antialiasing", 2016, in the isotropic form of Tokuyoshi and Kaplanyan, "Improved
// geometric specular antialiasing", 2019.
float normalVariance(vec3 normal) {
    const float pixelVariance = 0.15915494;  // 1 / 2 pi: of a Gaussian pixel filter, pixels squared
    const float maxVariance = 0.18;
    vec3 unit = normal * inversesqrt(max(dot(normal, normal), 1.0e-30));
    vec3 across = dFdx(unit), up = dFdy(unit);
    return frame.cameraForward.w * min(2.0 * pixelVariance * (dot(across, across) + dot(up, up)), maxVariance);
}

float alpha2Of(float roughness) {
    float alpha = max(roughness * roughness, MIN_ALPHA);
    return alpha * alpha;
}

// On flat surfaces the interpolation leaves rounding, which must not change the code that is stored.
bool widens(float variance, float alpha2) {
    return variance > 1.0e-4 * alpha2;
}

// The roughness whose lobe is as wide as that of `roughness` spread over the normals within the pixel. `normal` has any length.
float filteredRoughness(float roughness, vec3 normal) {
    float variance = normalVariance(normal), alpha2 = alpha2Of(roughness);
    return widens(variance, alpha2) ? sqrt(sqrt(min(alpha2 + variance, 1.0))) : roughness;
}

// The code of that roughness, where `code` is that of `roughness`. Rounding never makes it less.
uint filteredRoughnessCode(float roughness, uint code, vec3 normal) {
    float variance = normalVariance(normal), alpha2 = alpha2Of(roughness);
    return widens(variance, alpha2) ? max(packAlpha2(min(alpha2 + variance, 1.0)), code) : code;
}

void writeWords(GBufferWords words) {
    surfaceWords = words.surface;
#ifdef LOBES
    lobeWords = words.lobes.lobes;
    diffuseTransmissionWord = words.lobes.diffuseTransmission;
#endif
}
