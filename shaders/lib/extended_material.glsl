// The records and textures of materials with more lobes; lib/render/gpu_scene/lobe_records.cpp writes them, shared/bindings.h lists their
// texels. The includer has lib/texture_coordinates.glsl.

#include "shared/reflectance.h"

layout(binding = LOBE_RECORDS_UNIT) uniform samplerBuffer lobeRecords;
layout(binding = LOBE_TEXTURES_UNIT) uniform sampler2D lobeTextures[LOBE_TEXTURE_COUNT];

const int SPECULAR_SLOT = 0, SPECULAR_COLOR_SLOT = 1, CLEARCOAT_SLOT = 2, CLEARCOAT_ROUGHNESS_SLOT = 3, CLEARCOAT_NORMAL_SLOT = 4,
          SHEEN_COLOR_SLOT = 5, SHEEN_ROUGHNESS_SLOT = 6, ANISOTROPY_SLOT = 7, IRIDESCENCE_SLOT = 8, IRIDESCENCE_THICKNESS_SLOT = 9,
          TRANSMISSION_SLOT = 10, THICKNESS_SLOT = 11, DIFFUSE_TRANSMISSION_SLOT = 12, DIFFUSE_TRANSMISSION_COLOR_SLOT = 13;

vec4 lobeTexel(uint material, int texel) {
    return texelFetch(lobeRecords, int(material) * LOBE_TEXELS + texel);
}

vec2 lobeCoordinate(uint material, int slot) {
    vec4 rowX = lobeTexel(material, LOBE_UV_ROWS + 2 * slot);
    vec4 rowY = lobeTexel(material, LOBE_UV_ROWS + 2 * slot + 1);
    vec3 uv = vec3(uvOfSet(rowX.w), 1.0);
    return vec2(dot(rowX.xyz, uv), dot(rowY.xyz, uv));
}

#define lobeSample(material, slot) texture(lobeTextures[slot], lobeCoordinate(material, slot))

// The surface at which lobes are evaluated; all directions in world space, on the side that is seen.
struct LobeFrame {
    vec3 meshNormal;  // without a normal texture
    vec3 normal;      // unit length
    vec3 tangent;     // 0 where the mesh has none
    vec3 bitangent;
    vec3 toEye;  // unit length
};

// The clear coat's normal, turned so that it is seen from its front (`seenCoatNormal` of shared/extended_lobes.h), by as much more as its
// packing may turn it back; any length over 0.
vec3 clearcoatNormal(uint material, LobeFrame surface) {
    vec3 mapped = lobeSample(material, CLEARCOAT_NORMAL_SLOT).xyz * 2.0 - 1.0;
    float scale = lobeTexel(material, LOBE_SPECULAR_COLOR).w;
    vec3 normal = mapped.x * scale * surface.tangent + mapped.y * scale * surface.bitangent + mapped.z * surface.meshNormal;
    bool usable = scale != 0.0 && surface.tangent != vec3(0.0) && dot(normal, normal) > 0.0;
    vec3 chosen = usable ? normal : surface.meshNormal;
    vec3 unit = chosen * inversesqrt(max(dot(chosen, chosen), 1.0e-30));
    return unit + surface.toEye * max(0.004 - dot(unit, surface.toEye), 0.0);
}

// Reflectance of the surface at normal incidence, linear Rec.709, and at grazing angles.
vec4 surfaceReflectance(uint material, LobeFrame surface, vec3 baseColor, float metallic) {
    vec4 specular = lobeTexel(material, LOBE_SPECULAR);
    float factor = specular.y * lobeSample(material, SPECULAR_SLOT).a;
    vec3 color = lobeTexel(material, LOBE_SPECULAR_COLOR).rgb * lobeSample(material, SPECULAR_COLOR_SLOT).rgb;
    vec3 dielectric = dielectricF0(specular.x, factor, color), metal = baseColor;
    vec4 film = lobeTexel(material, LOBE_IRIDESCENCE);
    float filmFactor = film.x * lobeSample(material, IRIDESCENCE_SLOT).r;
    float thickness = mix(film.z, film.w, lobeSample(material, IRIDESCENCE_THICKNESS_SLOT).g);
    if (filmFactor > 0.0) {
        float nDotV = max(dot(surface.normal, surface.toEye), 0.0);
        dielectric = mix(dielectric, iridescentF0(nDotV, dielectric, film.y, thickness), filmFactor);
        metal = mix(metal, iridescentF0(nDotV, metal, film.y, thickness), filmFactor);
    }
    return vec4(mix(dielectric, metal, metallic), mix(factor, 1.0, metallic));
}

// The wide direction of the specular lobe, and in w its strength.
vec4 anisotropyAt(uint material, LobeFrame surface) {
    vec4 factors = lobeTexel(material, LOBE_ANISOTROPY);
    vec3 mapped = lobeSample(material, ANISOTROPY_SLOT).rgb;
    vec2 along = factors.w > 0.5 ? mapped.rg * 2.0 - 1.0 : vec2(1.0, 0.0);
    vec2 turned = vec2(along.x * factors.y - along.y * factors.z, along.x * factors.z + along.y * factors.y);
    float strength = factors.x * (factors.w > 0.5 ? mapped.b : 1.0);
    return vec4(turned.x * surface.tangent + turned.y * surface.bitangent, strength);
}

// Colours in the working space.
ExtendedLobes extendedLobes(uint material, LobeFrame surface, vec3 baseColor, float metallic) {
    ExtendedLobes lobes;
    vec4 specular = lobeTexel(material, LOBE_SPECULAR);
    vec4 reflectance = surfaceReflectance(material, surface, baseColor, metallic);
    lobes.f0 = workingFromRec709(reflectance.rgb);
    lobes.f90 = reflectance.w;
    vec4 anisotropy = anisotropyAt(material, surface);
    lobes.anisotropy = anisotropy.w;
    lobes.anisotropyDirection = anisotropy.xyz;
    vec4 sheen = lobeTexel(material, LOBE_SHEEN);
    lobes.sheenColor = workingFromRec709(sheen.rgb * lobeSample(material, SHEEN_COLOR_SLOT).rgb);
    lobes.sheenRoughness = sheen.w * lobeSample(material, SHEEN_ROUGHNESS_SLOT).a;
    lobes.clearcoat = specular.z * lobeSample(material, CLEARCOAT_SLOT).r;
    lobes.clearcoatRoughness = specular.w * lobeSample(material, CLEARCOAT_ROUGHNESS_SLOT).g;
    lobes.clearcoatNormal = clearcoatNormal(material, surface);
    lobes.transmission = lobeTexel(material, LOBE_ABSORPTION).w * lobeSample(material, TRANSMISSION_SLOT).r;
    vec4 transmission = lobeTexel(material, LOBE_DIFFUSE_TRANSMISSION);
    lobes.diffuseTransmission = transmission.w * lobeSample(material, DIFFUSE_TRANSMISSION_SLOT).a;
    lobes.diffuseTransmissionColor = workingFromRec709(transmission.rgb * lobeSample(material, DIFFUSE_TRANSMISSION_COLOR_SLOT).rgb);
    return lobes;
}
