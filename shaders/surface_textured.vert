// Surfaces with textures, vertex colours, a mask or emission.

#include "lib/frame.glsl"
#include "lib/instance.glsl"

// The programs of surfaces and of instances write the same depth for the same vertex.
invariant gl_Position;

layout(location = POSITION_ATTRIBUTE) in vec3 position;
layout(location = NORMAL_ATTRIBUTE) in vec3 normal;
layout(location = DRAW_ATTRIBUTE) in uvec3 draw;
layout(location = TANGENT_ATTRIBUTE) in vec4 tangent;
layout(location = UV0_ATTRIBUTE) in vec2 uv0;
layout(location = UV1_ATTRIBUTE) in vec2 uv1;
layout(location = COLOR_ATTRIBUTE) in vec4 color;
#ifdef FURTHER_UVS
layout(location = FURTHER_UVS_ATTRIBUTE) in vec4 furtherUvPairs[FURTHER_UVS];
#endif

layout(location = 0) out vec3 worldNormal;
layout(location = 1) out vec4 worldTangent;
layout(location = 2) out vec4 uvs;
layout(location = 3) out vec4 vertexColor;
layout(location = 4) flat out uint material;
#ifdef SHADOWS
layout(location = 5) out vec4 shadowPlane;  // position relative to the eye; its product with the normal
#endif
#ifdef EXTENDED
layout(location = 6) out vec3 eyePosition;  // relative to the eye
#endif
#ifdef REFRACTION
layout(location = 7) flat out float instanceScale;
#endif
#ifdef FURTHER_UVS
layout(location = FURTHER_UVS_VARYING) out vec4 furtherUvs[FURTHER_UVS];
#endif
#ifdef LAYER
layout(location = 4, component = 1) flat out uint drawNumber;
#endif

void main() {
    vec3 world = instancePosition(draw.x, position);
    gl_Position = frame.clipFromWorld * vec4(world, 1.0);
    // Unit length at the vertex, interpolated linearly and not normalised again, as MikkTSpace specifies.
    worldNormal = unitOrZero(instanceNormal(draw.x, normal));
    worldTangent = vec4(unitOrZero(instanceDirection(draw.x, tangent.xyz)), tangent.w * instanceHandedness(draw.x));
    uvs = vec4(uv0, uv1);
#ifdef FURTHER_UVS
    furtherUvs = furtherUvPairs;
#endif
    vertexColor = color;
    material = draw.y;
#ifdef EXTENDED
    eyePosition = world - frame.eye.xyz;
#endif
#ifdef REFRACTION
    instanceScale = meanScale(draw.x);
#endif
#ifdef LAYER
    drawNumber = draw.z;
#endif
#ifdef SHADOWS
    shadowPlane = vec4(world - frame.eye.xyz, dot(world - frame.eye.xyz, worldNormal));
#endif
}
