// The box around the surfaces of each tile; one group a tile.

#include "lib/gbuffer_input.glsl"
#include "lib/tiles.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

shared vec3 lows[64];
shared vec3 highs[64];

const float NOWHERE = 1.0e30;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    uint lane = gl_LocalInvocationIndex;
    bool surface = all(lessThan(pixel, frame.size.xy)) && hasSurface(fetchWords(pixel));
    vec3 position = worldPosition(pixel, surface ? fetchDepth(pixel) : 1.0);
    lows[lane] = surface ? position : vec3(NOWHERE);
    highs[lane] = surface ? position : vec3(-NOWHERE);
    for (uint stride = 32u; stride > 0u; stride >>= 1) {
        barrier();
        if (lane < stride) {
            lows[lane] = min(lows[lane], lows[lane + stride]);
            highs[lane] = max(highs[lane], highs[lane + stride]);
        }
    }
    if (lane != 0u) return;
    uint tile = gl_WorkGroupID.y * uint(tileGridSize().x) + gl_WorkGroupID.x;
    tileBoxes[tile] = TileBox(vec4(lows[0], lows[0].x < NOWHERE ? 1.0 : 0.0), vec4(highs[0], 0.0));
    tileCounts[tile] = 0u;
}
