// What the geometry pass writes of a surface.

#include "shared/bindings.h"
#include "lib/gbuffer.glsl"

layout(location = SURFACE_OUTPUT) out uvec2 surfaceWords;
#ifdef SHADOWS
layout(location = SHADOW_OUTPUT) out uint shadowWord;

// The height of the smooth surface that the vertex normals describe over the triangle: the mean, weighted by barycentric coordinates, of
// the heights of the tangent planes at the vertices (Hanika, "Hacking the shadow terminator", Ray Tracing Gems II, 2021, and before it
// Boubekeur and Alexa, "Phong tessellation", 2008). `position` is relative to any origin; `normal` and `tangentPlane` are the vertex
// normal and its product with the vertex position, both interpolated.
void writeShadowWord(vec3 position, vec3 normal, float tangentPlane) {
    // A step to the right and one up turn counter-clockwise on what the eye sees, so that the normal points towards it.
    vec3 geometricNormal = cross(dFdx(position), dFdy(position));
    float height = tangentPlane - dot(normal, position);
    shadowWord = packShadowWord(geometricNormal, dot(normal, geometricNormal) < 0.0 ? -height : height);
}
#endif

void writeWords(GBufferWords words) {
    surfaceWords = words.surface;
}
