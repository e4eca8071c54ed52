// Adds up the triangles that are kept of each cluster of a block; a group takes a block.

#include "lib/triangle_filter_sum.glsl"

void main() {
    const uint run = BLOCK_CLUSTERS / THREADS;
    uint first = gl_WorkGroupID.x * BLOCK_CLUSTERS + gl_LocalInvocationIndex * run, end = min(first + run, groupCount());
    uint own = 0u;
    for (uint group = first; group < end; ++group) own += keptTriangles(group);
    uint before = sumBefore(own);
    for (uint group = first; group < end; ++group) {
        results[group].start = before;
        before += keptTriangles(group);
    }
    if (gl_LocalInvocationIndex == THREADS - 1u) sums[gl_WorkGroupID.x] = before;
}
