// Writes the indices of the triangles kept, in the order of the draws and of their triangles, and the commands that draw them.

#include "lib/triangle_filter.glsl"

layout(local_size_x = CLUSTER_TRIANGLES) in;

layout(std430, binding = FILTER_OUTPUT_STORAGE) writeonly buffer Output {
    uint keptIndices[];
};
// DrawCommand of lib/render/gpu_scene/draw_list.h.
struct Command {
    uint count, instanceCount, firstIndex;
    int baseVertex;
    uint baseInstance;
};
layout(std430, binding = FILTER_COMMANDS_STORAGE) buffer Commands {
    Command commands[];
};

// Triangles kept before a cluster.
uint startOf(uint group) {
    if (group == groupCount()) return sums[(group + BLOCK_CLUSTERS - 1u) / BLOCK_CLUSTERS];
    return sums[group / BLOCK_CLUSTERS] + results[group].start;
}

void main() {
    uint group = filterGroup(), lane = gl_LocalInvocationIndex;
    if (group >= groupCount()) return;
    uint index = drawOf(group);
    uint first = draws[index].firstGroup, start = startOf(group);
    if (group == first && lane == 0u) {
        commands[draws[index].command].firstIndex = 3u * start;
        commands[draws[index].command].count = 3u * (startOf(draws[index].groupEnd) - start);
    }
    uint bit = 1u << (lane % 32u);
    if ((results[group].kept[lane / 32u] & bit) == 0u) return;
    uint before = uint(bitCount(results[group].kept[lane / 32u] & (bit - 1u)));
    if (lane >= 32u) before += uint(bitCount(results[group].kept[0]));
    uint from = draws[index].firstIndex + 3u * ((group - first) * uint(CLUSTER_TRIANGLES) + lane), to = 3u * (start + before);
    for (uint corner = 0u; corner < 3u; ++corner) keptIndices[to + corner] = indices[from + corner];
}
