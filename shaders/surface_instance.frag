// The instance and the material at each pixel, counted from 1; and for the AOV motion where its point of the surface was.

#include "shared/bindings.h"

layout(binding = BASE_COLOR_UNIT) uniform sampler2D baseColorTexture;

layout(location = 0) flat in uint instance;
#if TEXTURED == 1
layout(location = 1) in vec4 uvs;
layout(location = 2) in float vertexAlpha;
#endif
layout(location = 3) flat in uint material;

layout(location = 0) out uvec2 surfaceId;
#ifdef MOTION
layout(location = 4) in vec4 previousPosition;

layout(location = 1) out vec4 previous;  // in the frame of the instance, and 1; 0 where its vertices rest
#endif

#if TEXTURED == 1
#include "lib/texture_coordinates.glsl"
#endif

void main() {
#if TEXTURED == 1
    // As in surface_textured.frag.
    float alpha = materialFactors(material).alpha * vertexAlpha * texture(baseColorTexture, textureCoordinate(material, BASE_COLOR_SLOT)).a;
    if (alpha < materialState(material).alphaCutoff) discard;
#endif
    surfaceId = uvec2(instance, material) + 1u;
#ifdef MOTION
    previous = previousPosition;
#endif
}
