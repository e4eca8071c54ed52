// Bins lights to tiles, one thread a light. Dispatched twice: FILL 0 counts the lights of each tile, FILL 1 writes them into its list. A
// light over many tiles is taken by the whole group, so that no thread has a long loop of its own.

#define Real float
#define SHARED_FUNCTION

#include "lib/tiles.glsl"
#include "shared/light_bounds.h"

layout(local_size_x = 64) in;

layout(binding = LIGHTS_UNIT) uniform samplerBuffer lightRecords;
layout(location = FIRST_LIGHT_LOCATION) uniform int firstLight;

const int FEW_TILES = 32;

struct Reach {
    vec3 position;
    float range2;
    TileRange tiles;
    uint light;
};

shared Reach wide[64];
shared uint wideCount;

ViewFrustum viewFrustum() {
    vec2 extent = vec2(frame.cameraRight.w, frame.cameraUp.w);
    vec2 shift = vec2(frame.rayStepX.w, frame.rayStepY.w);
    if (isOrthographic()) return ViewFrustum(frame.eye.w, 0.0, 0.0, 1.0, 1.0, extent.x, extent.y, shift.x, shift.y);
    return ViewFrustum(frame.eye.w, extent.x, extent.y, edgeScale(extent.x, shift.x), edgeScale(extent.y, shift.y), 0.0, 0.0, shift.x, shift.y);
}

TileGrid tileGrid() {
    return TileGrid(frame.size.x, frame.size.y, TILE, tileGridSize().x, tileGridSize().y);
}

int tileCount(Reach reach) {
    return (reach.tiles.right - reach.tiles.left + 1) * (reach.tiles.top - reach.tiles.bottom + 1);
}

void visit(Reach reach, int index) {
    int width = reach.tiles.right - reach.tiles.left + 1;
    int x = reach.tiles.left + index % width, y = reach.tiles.bottom + index / width;
    uint tile = uint(y * tileGridSize().x + x);
    TileBox box = tileBoxes[tile];
    vec3 beyond = max(max(box.low.xyz - reach.position, reach.position - box.high.xyz), 0.0);
    if (box.low.w == 0.0 || dot(beyond, beyond) >= reach.range2) return;
    uint slot = atomicAdd(tileCounts[tile], 1u);
#if FILL == 1
    uint start = tileStarts[tile], capacity = uint(tileLists.length());
    if (start < capacity && slot < capacity - start) tileLists[start + slot] = reach.light;
#endif
}

void main() {
    if (gl_LocalInvocationIndex == 0u) wideCount = 0u;
    barrier();
    int light = firstLight + int(gl_GlobalInvocationID.x);
    if (light < lightSpan.y) {
        vec4 place = texelFetch(lightRecords, light * LIGHT_TEXELS);
        float range = inversesqrt(place.w);
        vec3 way = place.xyz - frame.eye.xyz;
        float x = dot(way, frame.cameraRight.xyz), y = dot(way, frame.cameraUp.xyz), depth = dot(way, frame.cameraForward.xyz);
        if (distanceToFrustum(viewFrustum(), x, y, depth) <= range) {
            Reach reach = Reach(place.xyz, 1.0 / place.w, tilesUnder(tileGrid(), viewFrustum(), x, y, depth, range), uint(light));
            int count = tileCount(reach);
            if (count > FEW_TILES) {
                wide[atomicAdd(wideCount, 1u)] = reach;
            } else {
                for (int i = 0; i < count; ++i) visit(reach, i);
            }
        }
    }
    barrier();
    for (uint w = 0u; w < wideCount; ++w) {
        Reach reach = wide[w];
        int count = tileCount(reach);
        for (int i = int(gl_LocalInvocationIndex); i < count; i += 64) visit(reach, i);
    }
}
