// Sums of the triangles that the filter keeps, by groups of threads.

#include "lib/triangle_filter.glsl"

const uint THREADS = 256u;
layout(local_size_x = 256) in;

shared uint partial[THREADS];

// The sum of the `own` of all threads before this one.
uint sumBefore(uint own) {
    uint lane = gl_LocalInvocationIndex;
    partial[lane] = own;
    barrier();
    for (uint distance = 1u; distance < THREADS; distance *= 2u) {
        uint before = lane >= distance ? partial[lane - distance] : 0u;
        barrier();
        partial[lane] += before;
        barrier();
    }
    return partial[lane] - own;
}
