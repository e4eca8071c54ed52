// Where each tile's list starts: the sum of the counts before it; and how many groups shade each part of the lists. One group; each
// thread takes a run of tiles.

#include "lib/tiles.glsl"

layout(local_size_x = 256) in;

shared uint sums[256];
shared uint longest;

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
        longest = 0u;
    }
    barrier();
    uint start = sums[lane];
    for (uint tile = first; tile < end; ++tile) {
        tileStarts[tile] = start;
        atomicMax(longest, isListed(tile) ? tileCounts[tile] : uint(frame.lightCounts.x + frame.lightCounts.y));
        start += tileCounts[tile];
        tileCounts[tile] = 0u;
    }
    barrier();
    uint parts = uint(tileGroups.length()) / 3u;
    for (uint part = lane; part < parts; part += 256u) {
        bool used = part == 0u || part * uint(LIST_PART) < longest;
        tileGroups[3u * part] = used ? uint(tileGrid().x) : 0u;
        tileGroups[3u * part + 1u] = used ? uint(tileGrid().y) : 0u;
        tileGroups[3u * part + 2u] = used ? 1u : 0u;
    }
}
