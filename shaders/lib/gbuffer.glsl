// The G-buffer's encoding: the only place on the GPU that packs and unpacks it. Its C++ twin is lib/render/gbuffer.cpp.
//   x: base colour, sRGB-encoded, 8 bits a channel (R lowest); metallic 8 bits
//   y: octahedral normal, 12 bits an axis (code 1 to 4095, so that y is never 0); perceptual roughness 8 bits

struct GBufferSurface {
    vec3 normal;
    vec3 baseColor;  // linear, in the working space
    float metallic;
    float roughness;  // perceptual
};

vec3 srgbEncode(vec3 linear) {
    vec3 low = linear * 12.92;
    vec3 high = 1.055 * pow(max(linear, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThan(linear, vec3(0.0031308)));
}

vec3 srgbDecode(vec3 encoded) {
    vec3 low = encoded / 12.92;
    vec3 high = pow((encoded + 0.055) / 1.055, vec3(2.4));
    return mix(high, low, lessThan(encoded, vec3(0.04045)));
}

// Folds the lower half of the octahedron outwards; its own inverse. Source: Cigolle et al., "A survey of efficient
// representations for independent unit vectors", 2014.
vec2 octahedralFold(vec2 p) {
    return (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
}

uint packBaseColor(vec3 baseColor, float metallic) {
    return packUnorm4x8(vec4(srgbEncode(clamp(baseColor, 0.0, 1.0)), metallic));
}

uint packNormalRoughness(vec3 normal, float roughness) {
    vec2 p = normal.xy / max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1.0e-20);
    if (normal.z < 0.0) p = octahedralFold(p);
    uvec2 code = uvec2(floor(clamp(p, -1.0, 1.0) * 2047.0 + 2048.5));
    return code.x | code.y << 12 | uint(floor(clamp(roughness, 0.0, 1.0) * 255.0 + 0.5)) << 24;
}

GBufferSurface unpackSurface(uvec2 texel) {
    GBufferSurface surface;
    vec4 color = unpackUnorm4x8(texel.x);
    surface.baseColor = srgbDecode(color.rgb);
    surface.metallic = color.a;
    vec2 p = (vec2(texel.y & 0xfffu, texel.y >> 12 & 0xfffu) - 2048.0) * (1.0 / 2047.0);
    float z = 1.0 - abs(p.x) - abs(p.y);
    if (z < 0.0) p = octahedralFold(p);
    surface.normal = normalize(vec3(p, z));
    surface.roughness = float(texel.y >> 24) * (1.0 / 255.0);
    return surface;
}
