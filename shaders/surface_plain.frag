// Surfaces of plain materials into the G-buffer.

#include "lib/gbuffer_output.glsl"

layout(location = 0) in vec3 worldNormal;
layout(location = 1) flat in uint packedBaseColor;
layout(location = 2) flat in float roughness;
#ifdef SHADOWS
layout(location = 3) in vec4 shadowPlane;
#endif

void main() {
    // The octahedral encoding divides by |x| + |y| + |z|: the interpolated normal needs no normalisation.
    vec3 normal = gl_FrontFacing ? worldNormal : -worldNormal;
    writeWords(plainWords(uvec2(packedBaseColor, packNormalRoughness(normal, filteredRoughness(roughness, worldNormal)))));
    writeOcclusion(1.0, 0.0);
#ifdef SHADOWS
    writeShadowWord(shadowPlane.xyz, worldNormal, shadowPlane.w);
#endif
}
