// What the geometry pass writes of a surface.

#include "shared/bindings.h"
#include "lib/gbuffer.glsl"
#include "lib/frame.glsl"

layout(location = SURFACE_OUTPUT) out uvec2 surfaceWords;
#ifdef SHADOWS
layout(location = SHADOW_OUTPUT) out uint shadowWord;

// The height of the smooth surface that the vertex normals describe over the triangle: the mean, weighted by barycentric coordinates, of
// the heights of the tangent planes at the vertices (Hanika, "Hacking the shadow terminator", Ray Tracing Gems II, 2021, and before it
// Boubekeur and Alexa, "Phong tessellation", 2008). `position` is relative to the eye; `normal` and `tangentPlane` are the vertex
// normal and its product with the vertex position, both interpolated.
void writeShadowWord(vec3 position, vec3 normal, float tangentPlane) {
    // Beside the horizon of a plane, a derivative may reach to a pixel beyond it, where the plane goes on behind the eye: the cross product
    // is still normal to the plane, but its sign says nothing.
    vec3 geometricNormal = cross(dFdx(position), dFdy(position));
    vec3 way = isOrthographic() ? -frame.cameraForward.xyz : -position;
    if (dot(geometricNormal, way) < 0.0) geometricNormal = -geometricNormal;
    float height = tangentPlane - dot(normal, position);
    shadowWord = packShadowWord(geometricNormal, dot(normal, geometricNormal) < 0.0 ? -height : height);
}
#endif

#ifdef OCCLUSION
layout(location = OCCLUSION_OUTPUT) out float environmentShare;
#endif

// `red` is that of the occlusion texture (glTF 2.0, 3.9.3).
void writeOcclusion(float red, float strength) {
#ifdef OCCLUSION
    environmentShare = 1.0 + strength * (red - 1.0);
#endif
}

void writeWords(GBufferWords words) {
    surfaceWords = words.surface;
}
