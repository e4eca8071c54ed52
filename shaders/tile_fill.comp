// Brings lights to tiles, one thread a light. Drawn twice: FILL 0 counts the lights of each tile, FILL 1 writes them into its list. A light over many
// tiles is taken by the whole group, so that no thread walks far alone.

#include "lib/tiles.glsl"

layout(local_size_x = 64) in;

layout(binding = LIGHTS_UNIT) uniform samplerBuffer lightRecords;
layout(location = FIRST_LIGHT_LOCATION) uniform int firstLight;

const int FEW_TILES = 32;

struct Reach {
    vec3 position;
    float range2;
    ivec4 tiles;  // left, bottom, right, top: both ends included
    uint light;
};

shared Reach wide[64];
shared uint wideCount;

// Least and greatest share of the picture, along one axis, under a sphere beside the view axis.
vec2 projectedSpan(float side, float depth, float range, float halfExtent) {
    float reach = range * sqrt(max(side * side + depth * depth - range * range, 0.0));
    return 0.5 + (side * depth + vec2(-reach, reach)) * (0.5 / (halfExtent * (depth * depth - range * range)));
}

// The tiles under a light; false when it lies outside the frustum.
bool tilesUnder(vec3 position, float range, out ivec4 tiles) {
    vec3 way = position - frame.eye.xyz;
    float x = dot(way, frame.cameraRight.xyz), y = dot(way, frame.cameraUp.xyz), depth = dot(way, frame.cameraForward.xyz);
    vec2 halfExtent = vec2(frame.cameraRight.w, frame.cameraUp.w);
    vec2 outside = (abs(vec2(x, y)) - depth * halfExtent) * inversesqrt(1.0 + halfExtent * halfExtent);
    if (depth + range < frame.eye.w || outside.x > range || outside.y > range) return false;
    ivec2 last = tileGrid() - 1;
    tiles = ivec4(0, 0, last);
    if (depth - range <= frame.eye.w) return true;
    vec2 spanX = projectedSpan(x, depth, range, halfExtent.x) * float(frame.size.x) + vec2(-1.0, 1.0);
    vec2 spanY = projectedSpan(y, depth, range, halfExtent.y) * float(frame.size.y) + vec2(-1.0, 1.0);
    vec4 pixels = clamp(vec4(spanX.x, spanY.x, spanX.y, spanY.y), 0.0, float((max(last.x, last.y) + 1) * TILE));
    tiles = min(ivec4(pixels) / TILE, last.xyxy);
    return true;
}

void visit(Reach reach, int index) {
    int width = reach.tiles.z - reach.tiles.x + 1;
    int x = reach.tiles.x + index % width, y = reach.tiles.y + index / width;
    uint tile = uint(y * tileGrid().x + x);
    TileBox box = tileBoxes[tile];
    vec3 beyond = max(max(box.low.xyz - reach.position, reach.position - box.high.xyz), 0.0);
    if (box.low.w == 0.0 || dot(beyond, beyond) >= reach.range2) return;
    uint slot = atomicAdd(tileCounts[tile], 1u);
#if FILL == 1
    uint entry = tileStarts[tile] + slot;
    if (entry < uint(tileLists.length())) tileLists[entry] = reach.light;
#endif
}

int tileCount(Reach reach) { return (reach.tiles.z - reach.tiles.x + 1) * (reach.tiles.w - reach.tiles.y + 1); }

void main() {
    if (gl_LocalInvocationIndex == 0u) wideCount = 0u;
    barrier();
    int light = firstLight + int(gl_GlobalInvocationID.x);
    if (light < frame.lightCounts.x + frame.lightCounts.y) {
        vec4 place = texelFetch(lightRecords, light * LIGHT_TEXELS);
        Reach reach = Reach(place.xyz, 1.0 / place.w, ivec4(0), uint(light));
        if (tilesUnder(place.xyz, inversesqrt(place.w), reach.tiles)) {
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
