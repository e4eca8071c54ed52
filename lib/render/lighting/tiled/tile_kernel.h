#pragma once

#include "render/environment/environment_view.h"
#include "render/occlusion/hemisphere_block.h"
#include "render/occlusion/occlusion_view.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace candela {

/// Pixels along a side of a tile. Lights are binned to tiles, and one worker shades a tile.
constexpr int tileSize = 64;
/// Pixels along a side of a block. The last culling is for a block, and its pixels are shaded together.
constexpr int blockSize = 4;
/// Levels of the tree of boxes, from a block (0) to a tile.
constexpr int boxLevels = 5;

/// What the kernels read and write in a frame. Plain numbers only: each kernel is compiled for its own
/// instruction set and must not share inline functions with other files. Pictures are width × height, rows
/// from the bottom.
struct TileFrame {
    float eye[3], nearPlane;
    float rayCorner[3], rayStepX[3], rayStepY[3];  ///< As in `FrameUniforms`.
    float right[3], up[3], forward[3];             ///< Axes of the camera, world space.
    float halfExtent[2], base[2], shift[2];        ///< As in `ViewFrustum`.
    bool orthographic;
    float nearOverFar,
        depthScale;   ///< Of a perspective view: near / far plane (0 without one), and 1 less that.
    float pixelSide;  ///< Of a pixel, metres: at the distance of one metre in a perspective view.
    float farPlane, depthRange;  ///< Of an orthographic view: far plane, and far - near plane.
    int width, height;
    const std::uint32_t* surfaces;  ///< Two words a pixel: `GBufferTexel`.
    const float* depth;             ///< Reversed.
    float* radiance;                ///< Four floats a pixel.
    bool loadRadiance;              ///< Adds to what `radiance` holds; else overwrites it.

    const float* reach[4];  ///< x, y, z and range of each point and spot light, with `listPadding` more.
    const float* records;   ///< Eight floats a light: see `GpuLights`.
    const float* cones;     ///< Four floats a spot.
    std::uint32_t pointCount, localCount, directionalCount;

    const EnvironmentView* environment;  ///< Null in a frame without one.
    /// The share of the environment that each pixel sees, 0 to 255; null: all of it.
    const std::uint8_t* environmentVisibility;

    const std::uint32_t* shadowWords;  ///< One a pixel; null in a frame without shadows.
    const OcclusionView* occlusion;    ///< Null in a frame without shadows.
    /// Four a pixel, and one of diffuse transmission; null in a frame whose G-buffer has none.
    const std::uint32_t *lobeWords, *diffuseTransmission;
    float* shadowedCounts;  ///< One a pixel: gains the lights that are hidden from it, in place of shading.
                            ///< Null where pixels are shaded.

    const float* srgbDecode;   ///< 256 values.
    const float* albedoTable;  ///< Of the reflection model: see directional_albedo.h.
    const float* sheenTable;   ///< See sheen_albedo.h; null in a frame without lobe words.
    int albedoTableSize;
};

/// Elements that the kernels read and write past the end of a list: one vector of the widest instruction set.
constexpr int listPadding = 16;

/// Lights as the culling reads them, sorted by index.
struct LightColumns {
    float *x, *y, *z, *range2;
    std::uint32_t* index;
};

/// The memory of a worker for shadows. Slots are the lights of a box of `shadowLevel`, in the order of its
/// list.
struct ShadowScratch {
    InstanceList* locals;  ///< One a slot.
    std::uint32_t* lightOfSlot;
    InstanceList* directionals;  ///< One a directional light.
    std::uint16_t* visible;  ///< Of a block: for each of its lights the pixels that it reaches, a bit each.
    std::uint16_t* hidden;   ///< And those from which it is hidden.
    std::uint16_t* dimmed;   ///< And those that a part of it reaches: not 0 where `transmittance` is filled.
    float* transmittance;    ///< Of each light sixteen, one a pixel; null where no occluder blends.
    std::uint64_t raysAsked, raysTraced;
};

/// The memory of a worker. Each level has room for all lights of the tile and `listPadding` more.
struct TileScratch {
    LightColumns levels[boxLevels + 1];
    float boxes[boxLevels][(tileSize / blockSize) * (tileSize / blockSize)][6];
    bool occupied[boxLevels][(tileSize / blockSize) * (tileSize / blockSize)];
    std::uint64_t pairsEvaluated = 0;
    ShadowScratch shadows = {};  ///< Filled in frames with shadows.
};

/// The level of the boxes for which the instances are listed that may hide a light: 16 × 16 pixels.
constexpr int shadowLevel = 2;

/// The 32-bit words of a worker's memory for each light of a tile: five columns at each level.
constexpr int scratchWordsPerLight = 5 * (boxLevels + 1);

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
    /// For each `BrdfModel`: shades a tile by the `count` lights of `lights` (sorted indices).
    void (*shade[2])(const TileFrame& frame, int tileX, int tileY, const std::uint32_t* lights,
                     std::uint32_t count, TileScratch& scratch);
    /// Fills `block` with every `step`th pixel of rows and columns from (left, bottom) on.
    void (*readHemispheres)(const TileFrame& frame, int left, int bottom, int step, HemisphereBlock& block);
    /// Fills `packet` with rays that end at `distance` and start from the block's pixels in a direction over
    /// the plane z = 0 that becomes each pixel's.
    void (*aimRays)(const HemisphereBlock& block, const float* direction, float distance, RayPacket& packet);
};

/// The kernel for the widest instruction set that this processor has.
const TileKernel& tileKernel();

/// One for each instruction set that this build has and this processor runs, widest first.
std::vector<const TileKernel*> tileKernels();

}  // namespace candela
