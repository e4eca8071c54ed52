// Lines and points for the lists of fragments, between layer_fragment.vert and layer_fragment.frag.

#include "lib/wide_primitive.glsl"

layout(location = 0) in vec4 cornerUvs[];
layout(location = 1) in float cornerAlpha[];
layout(location = 2) in uvec2 cornerSurface[];
#ifdef FURTHER_UVS
layout(location = FURTHER_UVS_VARYING) in vec4 cornerFurtherUvs[][FURTHER_UVS];
#endif

layout(location = 0) out vec4 uvs;
layout(location = 1) out float vertexAlpha;
layout(location = 2) flat out uvec2 surface;
#ifdef FURTHER_UVS
layout(location = FURTHER_UVS_VARYING) out vec4 furtherUvs[FURTHER_UVS];
#endif

void writeVertex(float t, vec3 offset) {
    uvs = mix(cornerUvs[0], cornerUvs[LAST_CORNER], t);
#ifdef FURTHER_UVS
    for (int i = 0; i < FURTHER_UVS; ++i) furtherUvs[i] = mix(cornerFurtherUvs[0][i], cornerFurtherUvs[LAST_CORNER][i], t);
#endif
    vertexAlpha = mix(cornerAlpha[0], cornerAlpha[LAST_CORNER], t);
    surface = cornerSurface[0];
}
