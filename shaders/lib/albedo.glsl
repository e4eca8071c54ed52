// The directional albedo of the gltf model's specular lobe for F = 1; lib/scene/directional_albedo.h makes the table and says how it is laid out.

#include "shared/bindings.h"

layout(binding = ALBEDO_UNIT) uniform sampler2D albedoTexture;

const float ALBEDO_MIN_ALPHA = 1.0e-3;

float directionalAlbedo(float nDotV, float alpha) {
    ivec2 last = textureSize(albedoTexture, 0) - 1;
    vec2 position = vec2(nDotV * (1.0 + alpha) / (nDotV + alpha), (alpha - ALBEDO_MIN_ALPHA) / (1.0 - ALBEDO_MIN_ALPHA));
    vec2 texel = clamp(position, 0.0, 1.0) * vec2(last);
    ivec2 low = min(ivec2(texel), last - 1);
    vec2 share = texel - vec2(low);
    float a = mix(texelFetch(albedoTexture, low, 0).r, texelFetch(albedoTexture, low + ivec2(1, 0), 0).r, share.x);
    float b = mix(texelFetch(albedoTexture, low + ivec2(0, 1), 0).r, texelFetch(albedoTexture, low + ivec2(1, 1), 0).r, share.x);
    return mix(a, b, share.y);
}
