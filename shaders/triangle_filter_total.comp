// Adds up the triangles that are kept of all blocks. One group.

#include "lib/triangle_filter_sum.glsl"

void main() {
    uint blocks = (groupCount() + BLOCK_CLUSTERS - 1u) / BLOCK_CLUSTERS;
    uint run = (blocks + THREADS - 1u) / THREADS;
    uint first = min(gl_LocalInvocationIndex * run, blocks), end = min(first + run, blocks);
    uint own = 0u;
    for (uint block = first; block < end; ++block) own += sums[block];
    uint before = sumBefore(own);
    for (uint block = first; block < end; ++block) {
        uint count = sums[block];
        sums[block] = before;
        before += count;
    }
    if (gl_LocalInvocationIndex == THREADS - 1u) sums[blocks] = before;
}
