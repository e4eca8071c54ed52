// The G-buffer's encoding, read by C++ and GLSL both: the only place that packs and unpacks it, except that the tile kernels unpack vectors
// of pixels (lib/render/lighting/tiled/tile_shading.h). The includer has GLSL's vectors, GBufferSurface and the sRGB curve.
//   word 0: base colour, sRGB-encoded, 8 bits a channel (R lowest); metallic, 8 bits
//   word 1: octahedral normal, 12 bits an axis (codes 1 to 4095, so that the word is never 0); fourth root of the perceptual roughness, 8 bits
//   layer word, of layers of transparent surfaces: coverage, 16 bits; blur and spread of what is refracted, 8 bits each
//   refraction words, of layers of which a surface transmits: offset in pixels, two half floats; roots of the transmittance, 10 bits a channel
//   shadow word, of frames with shadows: lift in metres as a half float; octahedral geometric normal, 8 bits an axis
//   lobe words, of frames with materials of more lobes; all 0 where the two words above are all:
//     0: roots of F0, 8 bits a channel; F90, 8 bits
//     1: sheen colour, sRGB-encoded, 8 bits a channel; sheen roughness, 8 bits
//     2: normal and roughness of the clear coat, as word 1 above
//     3: clear coat; strength and direction of anisotropy; transmission: 8 bits each
//     and of diffuse transmission: colour, sRGB-encoded, 8 bits a channel; factor, 8 bits

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

// The code of alpha², the fourth power of the roughness, from MIN_ALPHA² to 1: within 0.17 of a step before it is rounded. A cubic fit over the
// binary logarithm, which the bits of the number give but for a parabola over the mantissa. On llvmpipe the four square roots that it stands
// for take a twentieth of the geometry pass.
SHARED_FUNCTION uint packAlpha2(float alpha2) {
    int bits = floatBitsToInt(alpha2);
    float mantissa = float(bits & 0x7fffff) * (1.0f / 8388608.0f);
    float octaves = float(bits) * (1.0f / 8388608.0f) - 127.0f + 0.343f * mantissa * (1.0f - mantissa);
    return uint(255.5f + octaves * (18.980148f + octaves * (0.39457941f + octaves * 4.1122171e-3f)));
}

SHARED_FUNCTION uint packNormal(vec3 normal) {
    uvec2 code = uvec2(clamp(octahedralOf(normal), -1.0f, 1.0f) * NORMAL_MAX + (NORMAL_CENTER + 0.5f));
    return code.x | code.y << 12;
}

SHARED_FUNCTION uint packNormalRoughness(vec3 normal, float roughness) {
    return packNormal(normal) | packRoughness(roughness) << 24;
}

SHARED_FUNCTION vec3 unpackNormal(uint word1) {
    return normalOfOctahedral((vec2(float(word1 & 0xfffu), float(word1 >> 12 & 0xfffu)) - NORMAL_CENTER) * (1.0f / NORMAL_MAX));
}

SHARED_FUNCTION vec3 unpackColor(uint word) {
    vec4 color = unpackUnorm4x8(word);
    return vec3(srgbDecode(color.x), srgbDecode(color.y), srgbDecode(color.z));
}

SHARED_FUNCTION GBufferSurface unpackSurfaceWords(uint word0, uint word1) {
    GBufferSurface surface;
    surface.lobes.baseColor = unpackColor(word0);
    surface.lobes.metallic = unpackUnorm4x8(word0).w;
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

// Two unit vectors perpendicular to a unit vector and to each other. Duff et al., "Building an orthonormal basis, revisited", 2017.
struct TangentFrame {
    vec3 x;
    vec3 y;
};

SHARED_FUNCTION TangentFrame tangentFrame(vec3 normal) {
    float side = normal.z < 0.0f ? -1.0f : 1.0f;
    float a = -1.0f / (side + normal.z);
    float b = normal.x * normal.y * a;
    TangentFrame axes;
    axes.x = vec3(1.0f + side * normal.x * normal.x * a, side * b, -side * normal.x);
    axes.y = vec3(b, side + normal.y * normal.y * a, -normal.y);
    return axes;
}

// A direction of a surface, 0 to 255: opposite ones have the same code, or 0 and 255. `normal` is as it is unpacked.
SHARED_FUNCTION uint packTangent(vec3 normal, vec3 direction) {
    TangentFrame axes = tangentFrame(normal);
    vec2 p = vec2(dot(direction, axes.x), dot(direction, axes.y));
    float along = (p.y < 0.0f ? -p.x : p.x) / max(abs(p.x) + abs(p.y), 1.0e-20f);
    return uint(floor(clamp(along * 0.5f + 0.5f, 0.0f, 1.0f) * 255.0f + 0.5f));
}

SHARED_FUNCTION vec3 unpackTangent(vec3 normal, uint code) {
    TangentFrame axes = tangentFrame(normal);
    float along = float(code) * (2.0f / 255.0f) - 1.0f;
    return normalize(axes.x * along + axes.y * (1.0f - abs(along)));
}

struct LobeWords {
    uvec4 lobes;
    uint diffuseTransmission;
};

// `normal` is that of word 1. Directions and normals have any length over 0.
SHARED_FUNCTION LobeWords packExtendedLobes(ExtendedLobes lobes, vec3 normal) {
    LobeWords words;
    vec3 f0 = clamp(lobes.f0, 0.0f, 1.0f);
    vec4 strengths = vec4(lobes.clearcoat, lobes.anisotropy, 0.0f, lobes.transmission);
    words.lobes = uvec4(packUnorm4x8(vec4(sqrt(f0.x), sqrt(f0.y), sqrt(f0.z), lobes.f90)),
                        (packBaseColor(lobes.sheenColor, 0.0f) & 0xffffffu) | packRoughness(lobes.sheenRoughness) << 24,
                        packNormalRoughness(lobes.clearcoatNormal, lobes.clearcoatRoughness),
                        packUnorm4x8(strengths) | packTangent(normal, lobes.anisotropyDirection) << 16);
    words.diffuseTransmission = packBaseColor(lobes.diffuseTransmissionColor, lobes.diffuseTransmission);
    return words;
}

SHARED_FUNCTION bool hasExtendedLobes(LobeWords words) {
    return words.lobes.z != 0u;
}

SHARED_FUNCTION ExtendedLobes unpackExtendedLobes(LobeWords words, vec3 normal) {
    ExtendedLobes lobes;
    vec4 reflectance = unpackUnorm4x8(words.lobes.x);
    vec4 strengths = unpackUnorm4x8(words.lobes.w);
    vec3 root = vec3(reflectance.x, reflectance.y, reflectance.z);
    lobes.f0 = root * root;
    lobes.f90 = reflectance.w;
    lobes.anisotropy = strengths.y;
    lobes.anisotropyDirection = unpackTangent(normal, words.lobes.w >> 16 & 0xffu);
    lobes.sheenColor = unpackColor(words.lobes.y);
    lobes.sheenRoughness = unpackRoughness(words.lobes.y >> 24);
    lobes.clearcoat = strengths.x;
    lobes.clearcoatRoughness = unpackRoughness(words.lobes.z >> 24);
    lobes.clearcoatNormal = unpackNormal(words.lobes.z);
    lobes.transmission = strengths.w;
    lobes.diffuseTransmission = unpackUnorm4x8(words.diffuseTransmission).w;
    lobes.diffuseTransmissionColor = unpackColor(words.diffuseTransmission);
    return lobes;
}

// 0 where there is no surface.
SHARED_FUNCTION uint packCoverage(float coverage) {
    return uint(floor(clamp(coverage, 0.0f, 1.0f) * 65535.0f + 0.5f));
}

SHARED_FUNCTION float unpackCoverage(uint layerWord) {
    return float(layerWord & 0xffffu) * (1.0f / 65535.0f);
}

// What is seen through a surface that transmits: the picture behind it, elsewhere.
struct Refraction {
    vec2 offset;         // pixels from the surface to where it is seen
    float blur;          // 0 to 1: the logarithm of its size, over that of the picture's
    float spread;        // of the offset, for red below and for blue above: a share of it, 0 to 0.5
    vec3 transmittance;  // of light, by colour
};

SHARED_FUNCTION uint packBlurAndSpread(Refraction refraction) {
    vec2 code = floor(clamp(vec2(refraction.blur, 2.0f * refraction.spread), 0.0f, 1.0f) * 255.0f + 0.5f);
    return uint(code.x) << 16 | uint(code.y) << 24;
}

SHARED_FUNCTION uint packTransmittance(vec3 transmittance) {
    vec3 kept = clamp(transmittance, 0.0f, 1.0f);
    uvec3 code = uvec3(floor(vec3(sqrt(kept.x), sqrt(kept.y), sqrt(kept.z)) * 1023.0f + 0.5f));
    return code.x | code.y << 10 | code.z << 20;
}

SHARED_FUNCTION Refraction unpackRefraction(uint layerWord, uvec2 words) {
    Refraction refraction;
    refraction.offset = unpackHalf2x16(words.x);
    refraction.blur = float(layerWord >> 16 & 0xffu) * (1.0f / 255.0f);
    refraction.spread = float(layerWord >> 24) * (0.5f / 255.0f);
    vec3 root = vec3(float(words.y & 0x3ffu), float(words.y >> 10 & 0x3ffu), float(words.y >> 20 & 0x3ffu)) * (1.0f / 1023.0f);
    refraction.transmittance = root * root;
    return refraction;
}
