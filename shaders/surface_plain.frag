#include "lib/gbuffer.glsl"

layout(location = 0) in vec3 worldNormal;
layout(location = 1) flat in uint packedBaseColor;
layout(location = 2) flat in float roughness;

layout(location = 0) out uvec2 surface;

void main() {
    // The octahedral code divides by |x| + |y| + |z|, so that the interpolated normal needs no normalising.
    vec3 normal = gl_FrontFacing ? worldNormal : -worldNormal;
    surface = uvec2(packedBaseColor, packNormalRoughness(normal, roughness));
}
