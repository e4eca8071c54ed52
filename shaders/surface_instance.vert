// Surfaces for the instance pass: positions, and what the alpha mask depends on.

#include "lib/frame.glsl"
#include "lib/instance.glsl"

// The programs of surfaces and of instances write the same depth for the same vertex.
invariant gl_Position;

layout(location = POSITION_ATTRIBUTE) in vec3 position;
layout(location = DRAW_ATTRIBUTE) in uvec2 draw;
#if TEXTURED == 1
layout(location = UV0_ATTRIBUTE) in vec2 uv0;
layout(location = UV1_ATTRIBUTE) in vec2 uv1;
layout(location = COLOR_ATTRIBUTE) in vec4 color;
#ifdef FURTHER_UVS
layout(location = FURTHER_UVS_ATTRIBUTE) in vec4 furtherUvPairs[FURTHER_UVS];
#endif

layout(location = 1) out vec4 uvs;
layout(location = 2) out float vertexAlpha;
#ifdef FURTHER_UVS
layout(location = FURTHER_UVS_VARYING) out vec4 furtherUvs[FURTHER_UVS];
#endif
#endif

layout(location = 0) flat out uint instance;
layout(location = 3) flat out uint material;
#ifdef MOTION
layout(binding = PREVIOUS_VERTICES_UNIT) uniform samplerBuffer previousVertices;
layout(binding = PREVIOUS_OFFSETS_UNIT) uniform usamplerBuffer previousOffsets;

layout(location = 4) out vec4 previousPosition;
#endif

void main() {
    gl_Position = frame.clipFromWorld * vec4(instancePosition(draw.x, position), 1.0);
    instance = draw.x;
    material = draw.y;
#ifdef MOTION
    int offset = int(texelFetch(previousOffsets, int(draw.x)).r);
    previousPosition = offset == PREVIOUS_NONE ? vec4(0.0) : texelFetch(previousVertices, offset + gl_VertexID);
#endif
#if TEXTURED == 1
    uvs = vec4(uv0, uv1);
#ifdef FURTHER_UVS
    furtherUvs = furtherUvPairs;
#endif
    vertexAlpha = color.a;
#endif
}
