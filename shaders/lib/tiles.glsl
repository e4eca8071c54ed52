// What the compute passes of the technique `tiles` share: tiles of 8×8 pixels, the box of each tile's surfaces, and lists of lights.

#include "lib/frame.glsl"

const int TILE = 8;

struct TileBox {
    vec4 low;   // w: 1 where the tile has a surface that light falls on
    vec4 high;
};

layout(std430, binding = TILE_BOXES_STORAGE) buffer TileBoxes { TileBox tileBoxes[]; };
layout(std430, binding = TILE_COUNTS_STORAGE) buffer TileCounts { uint tileCounts[]; };
layout(std430, binding = TILE_STARTS_STORAGE) buffer TileStarts { uint tileStarts[]; };
layout(std430, binding = TILE_LISTS_STORAGE) buffer TileLists { uint tileLists[]; };
// x: entries that all lists need; what is beyond the capacity of tileLists is not written, and its tiles walk all lights instead.
layout(std430, binding = TILE_TOTAL_STORAGE) buffer TileTotal { uvec4 tileTotal; };

// The groups of tile_shade.comp for each part of the lists: three words a part, 0 where no list is so long.
layout(std430, binding = TILE_GROUPS_STORAGE) buffer TileGroups { uint tileGroups[]; };

// Does the tile's list lie within the buffer?
bool isListed(uint tile) { return tileStarts[tile] + tileCounts[tile] <= uint(tileLists.length()); }

ivec2 tileGrid() { return (frame.size.xy + TILE - 1) / TILE; }
