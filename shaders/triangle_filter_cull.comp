// Which triangles of a cluster may leave a trace in the picture.

#define Real float
#define Mask bool
#define SHARED_FUNCTION
#define splat(number) (number)

#include "lib/triangle_filter.glsl"

layout(local_size_x = CLUSTER_TRIANGLES) in;

layout(std430, binding = FILTER_CLUSTERS_STORAGE) readonly buffer Clusters {
    TriangleCluster clusters[];
};
layout(std430, binding = FILTER_VERTICES_STORAGE) readonly buffer Vertices {
    float vertices[];  // position and normal
};

bool both(bool a, bool b) {
    return a && b;
}
bool either(bool a, bool b) {
    return a || b;
}
bool negated(bool a) {
    return !a;
}
float select(bool mask, float a, float b) {
    return mask ? a : b;
}
float reciprocal(float a) {
    return 1.0 / a;
}
float wholeNumber(float a) {
    return ceil(a);
}

#include "shared/triangle_filter.h"

shared uint kept[2];

ClusterBounds boundsOf(TriangleCluster cluster) {
    return ClusterBounds(cluster.center[0], cluster.center[1], cluster.center[2], cluster.radius, cluster.axis[0], cluster.axis[1],
                         cluster.axis[2], cluster.cosine, cluster.altitude);
}

ScreenCorner cornerAt(FilterDraw draw, uint index) {
    uint first = uint(draw.baseVertex + int(indices[draw.firstIndex + index])) * 6u;
    return cornerOf(draw.view, vertices[first], vertices[first + 1u], vertices[first + 2u]);
}

void main() {
    uint group = filterGroup(), lane = gl_LocalInvocationIndex;
    if (group >= groupCount()) return;
    FilterDraw draw = draws[drawOf(group)];
    uint cluster = group - draw.firstGroup;
    bool tested = mayShowAny(draw.view, boundsOf(clusters[draw.firstCluster + cluster]));
    if (lane < 2u) kept[lane] = 0u;
    barrier();
    uint index = 3u * (cluster * uint(CLUSTER_TRIANGLES) + lane);
    if (tested && index < draw.indexCount) {
        if (mayShow(draw.view, cornerAt(draw, index), cornerAt(draw, index + 1u), cornerAt(draw, index + 2u)))
            atomicOr(kept[lane / 32u], 1u << (lane % 32u));
    }
    barrier();
    if (lane == 0u) results[group] = ClusterResult(uint[2](kept[0], kept[1]), tested ? 1u : 0u, 0u);
}
