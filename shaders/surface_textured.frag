// Surfaces with textures, vertex colours, a mask or emission into the G-buffer and the radiance target. EXTENDED is defined for those with
// more lobes than metallic-roughness.

#include "lib/frame.glsl"
#include "lib/gbuffer_output.glsl"

layout(binding = BASE_COLOR_UNIT) uniform sampler2D baseColorTexture;
layout(binding = METALLIC_ROUGHNESS_UNIT) uniform sampler2D metallicRoughnessTexture;
layout(binding = NORMAL_UNIT) uniform sampler2D normalTexture;
layout(binding = EMISSION_UNIT) uniform sampler2D emissionTexture;
#ifdef OCCLUSION
layout(binding = OCCLUSION_TEXTURE_UNIT) uniform sampler2D occlusionTexture;
#endif

layout(location = 0) in vec3 worldNormal;
layout(location = 1) in vec4 worldTangent;
layout(location = 2) in vec4 uvs;  // sets 0 and 1 of texture coordinates
layout(location = 3) in vec4 vertexColor;
layout(location = 4) flat in uint material;
#ifdef SHADOWS
layout(location = 5) in vec4 shadowPlane;
#endif
#ifdef EXTENDED
layout(location = 6) in vec3 eyePosition;  // relative to the eye
#endif

#ifdef REFRACTION
layout(location = 7) flat in float instanceScale;
#endif
#ifdef LAYER
layout(location = 4, component = 1) flat in uint drawNumber;
#endif

layout(location = RADIANCE_OUTPUT) out vec4 radiance;

#include "lib/texture_coordinates.glsl"
#ifdef LAYER
#include "lib/layer_output.glsl"
#endif
#ifdef EXTENDED
#include "lib/extended_material.glsl"
#endif
#ifdef REFRACTION
#include "lib/refraction.glsl"
#endif

vec4 texel(sampler2D image, int slot) {
    return texture(image, textureCoordinate(material, slot));
}

MaterialLobes texturedLobes() {
    MaterialLobes lobes = materialFactors(material);
    vec4 color = vec4(lobes.baseColor, lobes.alpha) * vertexColor * texel(baseColorTexture, BASE_COLOR_SLOT);
    vec2 metallicRoughness = vec2(lobes.metallic, lobes.roughness) * texel(metallicRoughnessTexture, METALLIC_ROUGHNESS_SLOT).bg;
    vec3 emission = lobes.emission * texel(emissionTexture, EMISSION_SLOT).rgb;
    return MaterialLobes(color.rgb, color.a, metallicRoughness.x, metallicRoughness.y, emission);
}

vec3 bitangentOf(vec4 tangent) {
    return cross(worldNormal, tangent.xyz) * tangent.w;
}

vec3 shadingNormal(float normalScale) {
    vec3 mapped = texel(normalTexture, NORMAL_SLOT).xyz * 2.0 - 1.0;
    vec3 bitangent = bitangentOf(worldTangent);
    vec3 normal = mapped.x * normalScale * worldTangent.xyz + mapped.y * normalScale * bitangent + mapped.z * worldNormal;
    bool usable = worldTangent.xyz != vec3(0.0) && dot(normal, normal) > 0.0;
    return usable ? normal : worldNormal;
}

#ifdef EXTENDED
// `normal` is on the side that is seen.
LobeFrame lobeFrame(vec3 normal) {
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 way = isOrthographic() ? -frame.cameraForward.xyz : -eyePosition;
    return LobeFrame(worldNormal * side, normal * inversesqrt(max(dot(normal, normal), 1.0e-30)), worldTangent.xyz * side,
                     bitangentOf(worldTangent) * side, normalize(way));
}

// `baseColor` is linear Rec.709.
LobeWords extendedWords(uint normalWord, LobeFrame surface, vec3 baseColor, float metallic) {
    ExtendedLobes lobes = extendedLobes(material, surface, baseColor, metallic);
    lobes.clearcoatRoughness = filteredRoughness(lobes.clearcoatRoughness, lobes.clearcoatNormal);
    return packExtendedLobes(lobes, unpackNormal(normalWord));
}
#endif

void main() {
    MaterialLobes lobes = texturedLobes();
    MaterialState state = materialState(material);
    vec3 normal = shadingNormal(state.normalScale);
    vec3 seenNormal = gl_FrontFacing ? normal : -normal;
    uint roughnessCode = filteredRoughnessCode(lobes.roughness, packRoughness(lobes.roughness), normal);
    uint normalRoughness = packNormal(seenNormal) | roughnessCode << 24;
#ifdef OCCLUSION
    writeOcclusion(texel(occlusionTexture, OCCLUSION_SLOT).r, state.occlusionStrength);
#endif
#ifdef SHADOWS
    writeShadowWord(shadowPlane.xyz, worldNormal, shadowPlane.w);
#endif
#ifdef EXTENDED
    LobeFrame surface = lobeFrame(seenNormal);
    LobeWords extended = extendedWords(normalRoughness, surface, lobes.baseColor, lobes.metallic);
#ifdef REFRACTION
    Refraction refraction = refractionOf(material, surface, eyePosition, lobes.roughness, instanceScale);
    refraction.transmittance = workingFromRec709(refraction.transmittance);
#endif
#endif
    // After all textures have been read: a discarded fragment still gives its neighbours the derivatives.
#ifdef LAYER
    float coverage = layerCoverage(lobes.alpha, state);
    if (!isInLayer(coverage, drawNumber)) discard;
#if defined(REFRACTION) && defined(EXTENDED)
    writeRefraction(coverage, refraction);
#elif defined(REFRACTION)
    writeNoRefraction(coverage);
#else
    writeLayer(coverage);
#endif
#else
    if (lobes.alpha < state.alphaCutoff) discard;
#endif

    vec3 working = workingFromRec709(lobes.baseColor);
    GBufferWords words = plainWords(uvec2(packBaseColor(working, lobes.metallic), state.unlit ? 0u : normalRoughness));
#ifdef EXTENDED
    words.lobes = extended;
#endif
    writeWords(words);
    radiance = vec4(state.unlit ? working : workingFromRec709(lobes.emission), 0.0);
#ifdef WITHOUT_NORMALS
    // Lines and points without normals show base colour and emission (glTF 2.0, 3.9.7).
    writeWords(plainWords(uvec2(packBaseColor(working, lobes.metallic), 0u)));
    if (!state.unlit) radiance.rgb += working;
#endif
}
