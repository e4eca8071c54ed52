// The greatest first component of a picture whose values are 0 or more.

#include "lib/frame.glsl"
#include "lib/max_reduction.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = SHOWN_UNIT) uniform sampler2D picture;

shared uint ofGroup;

void main() {
    if (gl_LocalInvocationIndex == 0u) ofGroup = 0u;
    barrier();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, frame.size.xy))) atomicMax(ofGroup, floatBitsToUint(texelFetch(picture, pixel, 0).x));
    barrier();
    if (gl_LocalInvocationIndex == 0u) atomicMax(greatest, ofGroup);
}
