// Where each tile's list starts: the sum of the counts before it; and how many groups shade each part of the lists. One group; each
// thread takes a run of tiles. Sums saturate, so that lists beyond 2^32 entries count as not listed.

#include "lib/tiles.glsl"

layout(local_size_x = 256) in;

layout(location = LIST_PART_LOCATION) uniform int partLights;

shared uint sums[256];
shared uint longest;

uint saturatingSum(uint a, uint b) {
    uint sum = a + b;
    return sum < a ? 0xffffffffu : sum;
}

void main() {
    uint tiles = uint(tileGridSize().x * tileGridSize().y);
    uint lane = gl_LocalInvocationIndex, run = (tiles + 255u) / 256u;
    uint first = min(lane * run, tiles), end = min(first + run, tiles);
    uint sum = 0u;
    for (uint tile = first; tile < end; ++tile) sum = saturatingSum(sum, tileCounts[tile]);
    sums[lane] = sum;
    barrier();
    if (lane == 0u) {
        uint before = 0u;
        for (uint i = 0u; i < 256u; ++i) {
            uint own = sums[i];
            sums[i] = before;
            before = saturatingSum(before, own);
        }
        tileTotal = uvec4(max(tileTotal.x, before), 0u, 0u, 0u);
        // The first span brings the directional lights, too.
        longest = lightSpan.x == 0 ? uint(frame.lightCounts.z) : 0u;
    }
    barrier();
    uint start = sums[lane];
    for (uint tile = first; tile < end; ++tile) {
        tileStarts[tile] = start;
        atomicMax(longest, isListed(tile) ? tileCounts[tile] : uint(lightSpan.y - lightSpan.x));
        start = saturatingSum(start, tileCounts[tile]);
        tileCounts[tile] = 0u;
    }
    barrier();
    uint parts = uint(tileGroups.length()) / 3u;
    for (uint part = lane; part < parts; part += 256u) {
        bool used = part == 0u || part * uint(partLights) < longest;
        tileGroups[3u * part] = used ? uint(tileGridSize().x) : 0u;
        tileGroups[3u * part + 1u] = used ? uint(tileGridSize().y) : 0u;
        tileGroups[3u * part + 2u] = used ? 1u : 0u;
    }
}
