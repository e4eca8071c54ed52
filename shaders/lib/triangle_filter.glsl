// What the passes of the triangle filter share (lib/render/culling/compute_triangle_filter.h). A group of threads takes a cluster, a thread
// a triangle.

#include "shared/bindings.h"
#include "shared/triangle_filter_records.h"

layout(std430, binding = FILTER_DRAWS_STORAGE) readonly buffer Draws {
    FilterDraw draws[];
};
layout(std430, binding = FILTER_INDICES_STORAGE) readonly buffer Indices {
    uint indices[];
};
layout(std430, binding = FILTER_RESULTS_STORAGE) buffer Results {
    ClusterResult results[];
};
layout(std430, binding = FILTER_SUMS_STORAGE) buffer Sums {
    uint sums[];  // triangles kept in a block, then: before it; and one more
};

layout(location = FILTER_COUNTS_LOCATION) uniform ivec2 filterCounts;

uint groupCount() {
    return uint(filterCounts.y);
}

uint filterGroup() {
    return gl_WorkGroupID.y * GROUPS_PER_ROW + gl_WorkGroupID.x;
}

// The draw of a group.
uint drawOf(uint group) {
    uint first = 0u, end = uint(filterCounts.x);
    while (end - first > 1u) {
        uint middle = (first + end) / 2u;
        if (draws[middle].firstGroup <= group)
            first = middle;
        else
            end = middle;
    }
    return first;
}

uint keptTriangles(uint group) {
    return uint(bitCount(results[group].kept[0]) + bitCount(results[group].kept[1]));
}
