// Surfaces whose material has no texture, no vertex colours and no emission: only the normal varies within a draw.

#include "lib/frame.glsl"
#include "lib/instance.glsl"
#include "lib/material.glsl"

// The programs of surfaces and of instances write the same depth for the same vertex.
invariant gl_Position;

layout(location = POSITION_ATTRIBUTE) in vec3 position;
layout(location = NORMAL_ATTRIBUTE) in vec3 normal;
layout(location = DRAW_ATTRIBUTE) in uvec2 draw;

layout(location = 0) out vec3 worldNormal;
layout(location = 1) flat out uvec3 material;
#ifdef SHADOWS
layout(location = 2) out vec4 shadowPlane;  // position relative to the eye; its product with the normal
#endif

void main() {
    vec3 world = instancePosition(draw.x, position);
    gl_Position = frame.clipFromWorld * vec4(world, 1.0);
    worldNormal = unitOrZero(instanceNormal(draw.x, normal));
    material = uvec3(materialWords(draw.y, MATERIAL_PACKED).xw, materialWords(draw.y, MATERIAL_FACTORS).y);
#ifdef SHADOWS
    shadowPlane = vec4(world - frame.eye.xyz, dot(world - frame.eye.xyz, worldNormal));
#endif
}
