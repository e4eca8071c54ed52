// Surfaces of plain materials into the G-buffer.

#include "lib/gbuffer_output.glsl"

layout(location = 0) in vec3 worldNormal;
layout(location = 1) flat in uvec3 material;  // base colour and roughness as they are stored; roughness
#ifdef SHADOWS
layout(location = 2) in vec4 shadowPlane;
#endif

void main() {
    // The octahedral encoding divides by |x| + |y| + |z|: the interpolated normal needs no normalisation.
    vec3 normal = gl_FrontFacing ? worldNormal : -worldNormal;
    uint code = filteredRoughnessCode(uintBitsToFloat(material.z), material.y, worldNormal);
    writeWords(plainWords(uvec2(material.x, packNormal(normal) | code << 24)));
    writeOcclusion(1.0, 0.0);
#ifdef SHADOWS
    writeShadowWord(shadowPlane.xyz, worldNormal, shadowPlane.w);
#endif
}
