// Lines and points with textures, vertex colours, a mask or emission, between surface_textured.vert and surface_textured.frag.

#include "lib/wide_primitive.glsl"

layout(location = 0) in vec3 cornerNormal[];
layout(location = 1) in vec4 cornerTangent[];
layout(location = 2) in vec4 cornerUvs[];
layout(location = 3) in vec4 cornerColor[];
layout(location = 4) in uint cornerMaterial[];
#ifdef SHADOWS
layout(location = 5) in vec4 cornerShadowPlane[];
#endif
#ifdef EXTENDED
layout(location = 6) in vec3 cornerEyePosition[];
#endif
#ifdef REFRACTION
layout(location = 7) in float cornerInstanceScale[];
#endif
#ifdef FURTHER_UVS
layout(location = FURTHER_UVS_VARYING) in vec4 cornerFurtherUvs[][FURTHER_UVS];
#endif
#ifdef LAYER
layout(location = 4, component = 1) in uint cornerDrawNumber[];
#endif

layout(location = 0) out vec3 worldNormal;
layout(location = 1) out vec4 worldTangent;
layout(location = 2) out vec4 uvs;
layout(location = 3) out vec4 vertexColor;
layout(location = 4) flat out uint material;
#ifdef SHADOWS
layout(location = 5) out vec4 shadowPlane;
#endif
#ifdef EXTENDED
layout(location = 6) out vec3 eyePosition;
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

void writeVertex(float t, vec3 offset) {
    worldNormal = mix(cornerNormal[0], cornerNormal[LAST_CORNER], t);
    worldTangent = mix(cornerTangent[0], cornerTangent[LAST_CORNER], t);
    uvs = mix(cornerUvs[0], cornerUvs[LAST_CORNER], t);
#ifdef FURTHER_UVS
    for (int i = 0; i < FURTHER_UVS; ++i) furtherUvs[i] = mix(cornerFurtherUvs[0][i], cornerFurtherUvs[LAST_CORNER][i], t);
#endif
    vertexColor = mix(cornerColor[0], cornerColor[LAST_CORNER], t);
    material = cornerMaterial[0];
#ifdef REFRACTION
    instanceScale = cornerInstanceScale[0];
#endif
#ifdef LAYER
    drawNumber = cornerDrawNumber[0];
#endif
#ifdef EXTENDED
    eyePosition = mix(cornerEyePosition[0], cornerEyePosition[LAST_CORNER], t) + offset;
#endif
#ifdef SHADOWS
    vec3 position = mix(cornerShadowPlane[0].xyz, cornerShadowPlane[LAST_CORNER].xyz, t) + offset;
    shadowPlane = vec4(position, dot(position, worldNormal));
#endif
}
