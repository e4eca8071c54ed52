// The texture coordinates of a fragment. The includer has `uvs`, which holds sets 0 and 1. FURTHER_UVS is defined for materials that read
// further ones: how many pairs of sets from 2 on there are.

#include "lib/material.glsl"

#ifdef FURTHER_UVS
layout(location = FURTHER_UVS_VARYING) in vec4 furtherUvs[FURTHER_UVS];
#endif

vec2 uvOfSet(float set) {
#ifdef FURTHER_UVS
    int further = int(set) - 2;
    if (further >= 0) {
        vec4 pair = furtherUvs[min(further >> 1, FURTHER_UVS - 1)];
        return (further & 1) != 0 ? pair.zw : pair.xy;
    }
#endif
    return set > 0.5 ? uvs.zw : uvs.xy;
}

// The transformed texture coordinate of texture `slot` of the material.
const int BASE_COLOR_SLOT = 0, METALLIC_ROUGHNESS_SLOT = 1, NORMAL_SLOT = 2, EMISSION_SLOT = 3, OCCLUSION_SLOT = 4;

vec2 textureCoordinate(uint material, int slot) {
    vec4 rowX = materialTexel(material, MATERIAL_UV_ROWS + 2 * slot);
    vec4 rowY = materialTexel(material, MATERIAL_UV_ROWS + 2 * slot + 1);
    vec3 uv = vec3(uvOfSet(rowX.w), 1.0);
    return vec2(dot(rowX.xyz, uv), dot(rowY.xyz, uv));
}
