// Lines and points for the instance pass, between surface_instance.vert and surface_instance.frag.

#include "lib/wide_primitive.glsl"

layout(location = 0) in uint cornerInstance[];
layout(location = 3) in uint cornerMaterial[];
#if TEXTURED == 1
layout(location = 1) in vec4 cornerUvs[];
layout(location = 2) in float cornerAlpha[];
#ifdef FURTHER_UVS
layout(location = FURTHER_UVS_VARYING) in vec4 cornerFurtherUvs[][FURTHER_UVS];
#endif
#endif

#ifdef MOTION
layout(location = 4) in vec4 cornerPrevious[];

layout(location = 4) out vec4 previousPosition;
#endif

layout(location = 0) flat out uint instance;
layout(location = 3) flat out uint material;
#if TEXTURED == 1
layout(location = 1) out vec4 uvs;
layout(location = 2) out float vertexAlpha;
#ifdef FURTHER_UVS
layout(location = FURTHER_UVS_VARYING) out vec4 furtherUvs[FURTHER_UVS];
#endif
#endif

void writeVertex(float t, vec3 offset) {
    instance = cornerInstance[0];
    material = cornerMaterial[0];
#ifdef MOTION
    previousPosition = mix(cornerPrevious[0], cornerPrevious[LAST_CORNER], t);
#endif
#if TEXTURED == 1
    uvs = mix(cornerUvs[0], cornerUvs[LAST_CORNER], t);
#ifdef FURTHER_UVS
    for (int i = 0; i < FURTHER_UVS; ++i) furtherUvs[i] = mix(cornerFurtherUvs[0][i], cornerFurtherUvs[LAST_CORNER][i], t);
#endif
    vertexAlpha = mix(cornerAlpha[0], cornerAlpha[LAST_CORNER], t);
#endif
}
