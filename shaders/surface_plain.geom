// Lines and points of plain materials, between surface_plain.vert and surface_plain.frag.

#include "lib/wide_primitive.glsl"

layout(location = 0) in vec3 cornerNormal[];
layout(location = 1) in uvec3 cornerMaterial[];
#ifdef SHADOWS
layout(location = 2) in vec4 cornerShadowPlane[];
#endif

layout(location = 0) out vec3 worldNormal;
layout(location = 1) flat out uvec3 material;
#ifdef SHADOWS
layout(location = 2) out vec4 shadowPlane;
#endif

void writeVertex(float t, vec3 offset) {
    worldNormal = mix(cornerNormal[0], cornerNormal[LAST_CORNER], t);
    material = cornerMaterial[0];
#ifdef SHADOWS
    vec3 position = mix(cornerShadowPlane[0].xyz, cornerShadowPlane[LAST_CORNER].xyz, t) + offset;
    shadowPlane = vec4(position, dot(position, worldNormal));
#endif
}
