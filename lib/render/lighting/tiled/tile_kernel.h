#pragma once

#include <cstdint>
#include <vector>

namespace candela {

/// Pixels along a side of a tile: the grain at which lights are binned. A tile is shaded by one worker.
constexpr int tileSize = 64;
/// Pixels along a side of a block: the grain at which lights are culled last and at which pixels are shaded
/// together.
constexpr int blockSize = 4;
/// Levels of boxes from a block (0) to a tile.
constexpr int boxLevels = 5;

/// What the kernels read and write in a frame. Plain numbers only: each kernel is compiled for its own
/// instruction set and must share no inline function with other files. Pictures are width × height with rows
/// from the bottom.
struct TileFrame {
    float eye[3], nearPlane;
    float rayCorner[3], rayStepX[3], rayStepY[3];  ///< As in `FrameUniforms`.
    float right[3], up[3], forward[3];             ///< Of the camera.
    float halfExtent[2], edgeScale[2];             ///< Of the frustum: see `Frustum`.
    int width, height;
    const std::uint32_t* surfaces;  ///< Two words a pixel: `GBufferTexel`.
    const float* depth;             ///< Reversed.
    float* radiance;                ///< Four floats a pixel.
    bool keepsEmission;             ///< `radiance` holds emission to add to; else it is overwritten.

    const float* reach[4];  ///< x, y, z and range of each point and spot light, with `listPadding` more.
    const float* records;   ///< Eight floats a light: shaders/lib/lights.glsl.
    const float* cones;     ///< Four floats a spot.
    std::uint32_t pointCount, localCount, directionalCount;

    const float* srgbDecode;   ///< 256 values.
    const float* albedoTable;  ///< See directional_albedo.h.
    int albedoTableSize;
};

/// How far the kernels read and write past the end of a list: one vector of the widest instruction set.
constexpr int listPadding = 16;

/// Lights as the culling reads them, in growing order of their index.
struct LightColumns {
    float *x, *y, *z, *range2;
    std::uint32_t* index;
};

/// The memory a worker needs. Each level holds the tile's lights and `listPadding` more.
struct TileScratch {
    LightColumns levels[boxLevels + 1];
    float boxes[boxLevels][(tileSize / blockSize) * (tileSize / blockSize)][6];
    bool occupied[boxLevels][(tileSize / blockSize) * (tileSize / blockSize)];
    std::uint64_t pairsEvaluated = 0;
};

/// A light in view and the tiles it may touch, both ends included.
struct VisibleLight {
    std::uint32_t index;
    std::uint16_t left, bottom, right, top;
};

/// The functions of one instruction set.
struct TileKernel {
    const char* name;
    /// Writes the lights from `first` to `end` that meet the frustum to `out` (room for end - first), and
    /// returns how many.
    std::size_t (*cull)(const TileFrame& frame, std::uint32_t first, std::uint32_t end, VisibleLight* out);
    /// Shades a tile by the `count` lights of `lights` (indices, growing), for the BRDF model that the kernel
    /// is of.
    void (*shade[2])(const TileFrame& frame, int tileX, int tileY, const std::uint32_t* lights,
                     std::uint32_t count, TileScratch& scratch);
};

/// The kernel for the widest instruction set that this processor has.
const TileKernel& tileKernel();

/// One for each instruction set that this build has and this processor runs, widest first.
std::vector<const TileKernel*> tileKernels();

}  // namespace candela
