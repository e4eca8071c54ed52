// Where each tile's list starts: the sum of the counts before it. One group; each thread sums a run of tiles.

#include "lib/tiles.glsl"

layout(local_size_x = 256) in;

shared uint sums[256];

void main() {
    uint tiles = uint(tileGrid().x * tileGrid().y);
    uint lane = gl_LocalInvocationIndex, run = (tiles + 255u) / 256u;
    uint first = min(lane * run, tiles), end = min(first + run, tiles);
    uint sum = 0u;
    for (uint tile = first; tile < end; ++tile) sum += tileCounts[tile];
    sums[lane] = sum;
    barrier();
    if (lane == 0u) {
        uint before = 0u;
        for (uint i = 0u; i < 256u; ++i) {
            uint own = sums[i];
            sums[i] = before;
            before += own;
        }
        tileTotal = uvec4(before, 0u, 0u, 0u);
    }
    barrier();
    uint start = sums[lane];
    for (uint tile = first; tile < end; ++tile) {
        tileStarts[tile] = start;
        start += tileCounts[tile];
        tileCounts[tile] = 0u;
    }
}
