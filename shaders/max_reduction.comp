// The largest first component of a texture whose values are 0 or more.

#include "lib/frame.glsl"
#include "lib/max_reduction.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = VIEW_UNIT) uniform sampler2D source;

shared uint groupMaximum;

void main() {
    if (gl_LocalInvocationIndex == 0u) groupMaximum = 0u;
    barrier();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, frame.size.xy))) atomicMax(groupMaximum, floatBitsToUint(texelFetch(source, pixel, 0).x));
    barrier();
    if (gl_LocalInvocationIndex == 0u) atomicMax(maximumBits, groupMaximum);
}
