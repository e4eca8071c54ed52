// The material records that GpuScene uploads; lib/render/material_records.cpp writes them.
//   0: base colour factor and alpha     1: metallic, roughness, normal scale, alpha cutoff (negative: no mask)
//   2: emission factor, 1 when unlit    3: base colour and metallic as the G-buffer packs them (uint), flags (uint)
//   4 to 11: two texels for each texture, base colour, metallic-roughness, normal, emission: the rows of its coordinate
//            transform; w of the first is the UV set

#include "shared/bindings.h"

layout(binding = MATERIALS_UNIT) uniform usamplerBuffer materialRecords;

uvec4 materialWords(uint material, int texel) { return texelFetch(materialRecords, int(material) * MATERIAL_TEXELS + texel); }

vec4 materialTexel(uint material, int texel) { return uintBitsToFloat(materialWords(material, texel)); }

// The coordinate that texture `slot` (0 to 3) of the material is read at.
vec2 textureCoordinate(uint material, int slot, vec2 uv0, vec2 uv1) {
    vec4 rowX = materialTexel(material, 4 + 2 * slot);
    vec4 rowY = materialTexel(material, 5 + 2 * slot);
    vec3 uv = vec3(rowX.w > 0.5 ? uv1 : uv0, 1.0);
    return vec2(dot(rowX.xyz, uv), dot(rowY.xyz, uv));
}
