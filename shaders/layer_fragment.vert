// Transparent surfaces for the lists of their fragments: positions, and what their coverage depends on.

#include "lib/frame.glsl"
#include "lib/instance.glsl"

// The programs of surfaces write the same depth for the same vertex.
invariant gl_Position;

layout(location = POSITION_ATTRIBUTE) in vec3 position;
layout(location = DRAW_ATTRIBUTE) in uvec3 draw;
layout(location = UV0_ATTRIBUTE) in vec2 uv0;
layout(location = UV1_ATTRIBUTE) in vec2 uv1;
layout(location = COLOR_ATTRIBUTE) in vec4 color;
#ifdef FURTHER_UVS
layout(location = FURTHER_UVS_ATTRIBUTE) in vec4 furtherUvPairs[FURTHER_UVS];
#endif

layout(location = 0) out vec4 uvs;
layout(location = 1) out float vertexAlpha;
layout(location = 2) flat out uvec2 surface;  // material, number of the draw
#ifdef FURTHER_UVS
layout(location = FURTHER_UVS_VARYING) out vec4 furtherUvs[FURTHER_UVS];
#endif

void main() {
    gl_Position = frame.clipFromWorld * vec4(instancePosition(draw.x, position), 1.0);
    uvs = vec4(uv0, uv1);
#ifdef FURTHER_UVS
    furtherUvs = furtherUvPairs;
#endif
    vertexAlpha = color.a;
    surface = draw.yz;
}
