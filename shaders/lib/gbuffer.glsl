// The G-buffer's encoding for shaders.

#define Real float
#define Real3 vec3
#define Scalar float
#define SHARED_FUNCTION

#include "shared/surface_lobes.h"

struct GBufferSurface {
    vec3 normal;  // world space, unit length
    SurfaceLobes lobes;
};

#include "shared/srgb.h"
#include "shared/gbuffer_encoding.h"

vec3 srgbEncode(vec3 linear) {
    return vec3(srgbEncode(linear.r), srgbEncode(linear.g), srgbEncode(linear.b));
}

GBufferSurface unpackSurface(uvec2 texel) {
    return unpackSurfaceWords(texel.x, texel.y);
}

// All words of a pixel: a member for each texture of the G-buffer's layout (lib/render/gbuffer/gbuffer_targets.h).
struct GBufferWords {
    uvec2 surface;
#ifdef LOBES
    LobeWords lobes;
#endif
};

// The words of a surface of a metallic-roughness material.
GBufferWords plainWords(uvec2 surface) {
    GBufferWords words;
    words.surface = surface;
#ifdef LOBES
    words.lobes = LobeWords(uvec4(0u), 0u);
#endif
    return words;
}

GBufferSurface unpackWords(GBufferWords words) {
    return unpackSurface(words.surface);
}
