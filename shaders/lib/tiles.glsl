// What the compute passes of the technique `tiles` share: tiles of 8×8 pixels, the box of each tile's surfaces, and lists of lights.

#include "lib/frame.glsl"

const int TILE = 8;

struct TileBox {
    vec4 low;  // w: 1 where the tile has a surface that light falls on
    vec4 high;
};

layout(std430, binding = TILE_BOXES_STORAGE) buffer TileBoxes {
    TileBox tileBoxes[];
};
layout(std430, binding = TILE_COUNTS_STORAGE) buffer TileCounts {
    uint tileCounts[];
};
layout(std430, binding = TILE_STARTS_STORAGE) buffer TileStarts {
    uint tileStarts[];
};
layout(std430, binding = TILE_LISTS_STORAGE) buffer TileLists {
    uint tileLists[];
};
// x: the maximum number of entries that the lists of one span of lights need, over the spans of the frame; saturates.
layout(std430, binding = TILE_TOTAL_STORAGE) buffer TileTotal {
    uvec4 tileTotal;
};

// The groups of tile_shade.comp for each part of the lists: three words a part, 0 where no list is so long.
layout(std430, binding = TILE_GROUPS_STORAGE) buffer TileGroups {
    uint tileGroups[];
};

// The lights that the lists are of: first and end. A frame may need several spans, whose lists fit into the buffer one after the other.
layout(location = LIGHT_SPAN_LOCATION) uniform ivec2 lightSpan;

// Does the tile's list lie within the buffer? Otherwise the tile iterates over all lights of the span.
bool isListed(uint tile) {
    uint capacity = uint(tileLists.length());
    return tileStarts[tile] <= capacity && tileCounts[tile] <= capacity - tileStarts[tile];
}

ivec2 tileGridSize() {
    return (frame.size.xy + TILE - 1) / TILE;
}
