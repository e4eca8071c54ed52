#include "lib/frame.glsl"
#include "lib/gbuffer.glsl"
#include "lib/material.glsl"

layout(binding = BASE_COLOR_UNIT) uniform sampler2D baseColorTexture;
layout(binding = METALLIC_ROUGHNESS_UNIT) uniform sampler2D metallicRoughnessTexture;
layout(binding = NORMAL_UNIT) uniform sampler2D normalTexture;
layout(binding = EMISSION_UNIT) uniform sampler2D emissionTexture;

layout(location = 0) in vec3 worldNormal;
layout(location = 1) in vec4 worldTangent;
layout(location = 2) in vec4 uvs;
layout(location = 3) in vec4 vertexColor;
layout(location = 4) flat in uint material;

layout(location = 0) out uvec2 surface;
layout(location = 1) out vec4 radiance;

vec3 shadingNormal(vec4 factors) {
    vec3 texel = texture(normalTexture, textureCoordinate(material, 2, uvs.xy, uvs.zw)).xyz * 2.0 - 1.0;
    vec3 bitangent = cross(worldNormal, worldTangent.xyz) * worldTangent.w;
    vec3 normal = texel.x * factors.z * worldTangent.xyz + texel.y * factors.z * bitangent + texel.z * worldNormal;
    bool usable = worldTangent.xyz != vec3(0.0) && dot(normal, normal) > 0.0;
    return usable ? normal : worldNormal;
}

void main() {
    vec4 factors = materialTexel(material, 1);
    vec4 baseColor = materialTexel(material, 0) * vertexColor *
                     texture(baseColorTexture, textureCoordinate(material, 0, uvs.xy, uvs.zw));
    vec2 metallicRoughness = factors.xy *
                             texture(metallicRoughnessTexture, textureCoordinate(material, 1, uvs.xy, uvs.zw)).bg;
    vec4 emission = materialTexel(material, 2);
    vec3 emitted = emission.rgb * texture(emissionTexture, textureCoordinate(material, 3, uvs.xy, uvs.zw)).rgb;
    vec3 normal = shadingNormal(factors);
    if (baseColor.a < factors.w) discard;

    bool unlit = emission.w > 0.5;
    vec3 working = workingFromRec709(baseColor.rgb);
    uint normalRoughness = packNormalRoughness(gl_FrontFacing ? normal : -normal, metallicRoughness.y);
    surface = uvec2(packBaseColor(working, metallicRoughness.x), unlit ? 0u : normalRoughness);
    radiance = vec4(unlit ? working : workingFromRec709(emitted), 0.0);
}
