// The G-buffer's encoding, read by C++ and GLSL both: the only place that packs and unpacks it, except that the tile kernels unpack vectors
// of pixels (lib/render/lighting/tiled/tile_shading.h). The includer has GLSL's vectors, GBufferSurface and the sRGB curve.
//   word 0: base colour, sRGB-encoded, 8 bits a channel (R lowest); metallic, 8 bits
//   word 1: octahedral normal, 12 bits an axis (codes 1 to 4095, so that the word is never 0); fourth root of the perceptual roughness, 8 bits
//   shadow word, of frames with shadows: lift in metres as a half float; octahedral geometric normal, 8 bits an axis

const float NORMAL_MAX = 2047.0f;     // code of 1, from the centre
const float NORMAL_CENTER = 2048.0f;  // code of 0

// Folds the lower half of the octahedron outwards; its own inverse. Cigolle et al., "A survey of efficient representations for independent
// unit vectors", 2014.
SHARED_FUNCTION vec2 octahedralFold(vec2 p) {
    return (1.0f - abs(vec2(p.y, p.x))) * vec2(p.x >= 0.0f ? 1.0f : -1.0f, p.y >= 0.0f ? 1.0f : -1.0f);
}

// The octahedral map of a vector of any length, -1 to 1 along each axis.
SHARED_FUNCTION vec2 octahedralOf(vec3 normal) {
    vec2 p = vec2(normal.x, normal.y) / max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.0e-20f);
    return normal.z < 0.0f ? octahedralFold(p) : p;
}

SHARED_FUNCTION vec3 normalOfOctahedral(vec2 p) {
    float z = 1.0f - abs(p.x) - abs(p.y);
    vec2 folded = z < 0.0f ? octahedralFold(p) : p;
    return normalize(vec3(folded.x, folded.y, z));
}

SHARED_FUNCTION uint packBaseColor(vec3 baseColor, float metallic) {
    vec3 color = clamp(baseColor, 0.0f, 1.0f);
    return packUnorm4x8(vec4(srgbEncode(color.x), srgbEncode(color.y), srgbEncode(color.z), metallic));
}

// Code 0 is roughness 0; codes 1 to 255 are even steps of the fourth root, from that of the least alpha that shading tells from 0 (MIN_ALPHA
// of shared/shading_constants.h) to 1. The height of a highlight, 1 / roughness^4, then has about the same relative error everywhere.
const float ROUGHNESS_STEP = 2.2767854e-3f;  // (1 - 0.001^(1/8)) / 254

SHARED_FUNCTION float unpackRoughness(uint code) {
    float root = 1.0f - float(255u - code) * ROUGHNESS_STEP;
    return code == 0u ? 0.0f : root * root * (root * root);
}

SHARED_FUNCTION uint packRoughness(float roughness) {
    float code = 255.0f - (1.0f - sqrt(sqrt(clamp(roughness, 0.0f, 1.0f)))) / ROUGHNESS_STEP;
    // Half of the roughness of code 1, and not half a step: code 0 lies farther away.
    if (roughness < 0.5f * unpackRoughness(1u)) return 0u;
    return uint(floor(max(code, 1.0f) + 0.5f));
}

SHARED_FUNCTION uint packNormalRoughness(vec3 normal, float roughness) {
    uvec2 code = uvec2(floor(clamp(octahedralOf(normal), -1.0f, 1.0f) * NORMAL_MAX + (NORMAL_CENTER + 0.5f)));
    return code.x | code.y << 12 | packRoughness(roughness) << 24;
}

SHARED_FUNCTION vec3 unpackNormal(uint word1) {
    return normalOfOctahedral((vec2(float(word1 & 0xfffu), float(word1 >> 12 & 0xfffu)) - NORMAL_CENTER) * (1.0f / NORMAL_MAX));
}

SHARED_FUNCTION GBufferSurface unpackSurfaceWords(uint word0, uint word1) {
    GBufferSurface surface;
    vec4 color = unpackUnorm4x8(word0);
    surface.lobes.baseColor = vec3(srgbDecode(color.x), srgbDecode(color.y), srgbDecode(color.z));
    surface.lobes.metallic = color.w;
    surface.normal = unpackNormal(word1);
    surface.lobes.roughness = unpackRoughness(word1 >> 24);
    return surface;
}

const float GEOMETRIC_NORMAL_MAX = 127.0f;     // code of 1, from the centre
const float GEOMETRIC_NORMAL_CENTER = 128.0f;  // code of 0

// What occlusion rays need of a surface (shaders/shared/shadow_ray.h).
struct ShadowSurface {
    vec3 geometricNormal;  // of the triangle, towards the eye; unit length
    float lift;            // metres along it, 0 or more
};

SHARED_FUNCTION uint packShadowWord(vec3 geometricNormal, float lift) {
    uvec2 code = uvec2(floor(clamp(octahedralOf(geometricNormal), -1.0f, 1.0f) * GEOMETRIC_NORMAL_MAX + (GEOMETRIC_NORMAL_CENTER + 0.5f)));
    return packHalf2x16(vec2(clamp(lift, 0.0f, 65504.0f), 0.0f)) | code.x << 16 | code.y << 24;
}

SHARED_FUNCTION ShadowSurface unpackShadowWord(uint word) {
    ShadowSurface surface;
    vec2 code = vec2(float(word >> 16 & 0xffu), float(word >> 24));
    surface.geometricNormal = normalOfOctahedral((code - GEOMETRIC_NORMAL_CENTER) * (1.0f / GEOMETRIC_NORMAL_MAX));
    surface.lift = unpackHalf2x16(word & 0xffffu).x;
    return surface;
}
