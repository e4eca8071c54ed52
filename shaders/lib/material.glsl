// The material records that GpuScene uploads; lib/render/gpu_scene/gpu_materials.cpp writes them, shared/bindings.h lists their texels.

#include "shared/bindings.h"

layout(binding = MATERIALS_UNIT) uniform usamplerBuffer materialRecords;

uvec4 materialWords(uint material, int texel) {
    return texelFetch(materialRecords, int(material) * MATERIAL_TEXELS + texel);
}

vec4 materialTexel(uint material, int texel) {
    return uintBitsToFloat(materialWords(material, texel));
}

// The lobes of a material at a point of a surface. Colours are linear Rec.709.
struct MaterialLobes {
    vec3 baseColor;
    float alpha;
    float metallic;
    float roughness;  // perceptual
    vec3 emission;
};

// What is not a factor of a texture.
struct MaterialState {
    float normalScale;  // 0 without a normal texture
    float alphaCutoff;  // negative without a mask; of what blends a half
    bool unlit;
    float occlusionStrength;  // 0 without an occlusion texture
    bool blends;
};

// The factors, which textures and vertex colours multiply.
MaterialLobes materialFactors(uint material) {
    vec4 color = materialTexel(material, MATERIAL_BASE_COLOR);
    vec4 factors = materialTexel(material, MATERIAL_FACTORS);
    return MaterialLobes(color.rgb, color.a, factors.x, factors.y, materialTexel(material, MATERIAL_EMISSION).rgb);
}

MaterialState materialState(uint material) {
    vec4 factors = materialTexel(material, MATERIAL_FACTORS);
    uvec4 words = materialWords(material, MATERIAL_PACKED);
    return MaterialState(factors.z, factors.w, materialTexel(material, MATERIAL_EMISSION).w > 0.5, uintBitsToFloat(words.y), words.z != 0u);
}
