#pragma once

// The kernels of the technique `tiles` on the CPU. Each tile_kernel_*.cpp includes this once and is compiled
// for its own instruction set, with CANDELA_TILE_KERNEL naming the table it defines. Everything here has
// internal linkage, and no inline function of a library is used, so that no code for one instruction set can
// end up in the place of another's.

#include "render/lighting/tiled/tile_kernel.h"

#include "render/lighting/tiled/tile_shading.h"

namespace candela {
namespace {

constexpr int blocksPerTile = tileSize / blockSize;
constexpr int pixelsPerBlock = blockSize * blockSize;
constexpr float nowhere = 1.0e30f;

/// The pixels of a block, row by row; those beside the picture read as background.
struct BlockPixels {
    float x[pixelsPerBlock], y[pixelsPerBlock], depth[pixelsPerBlock];
    std::uint32_t word0[pixelsPerBlock], word1[pixelsPerBlock];
};

inline bool isWhole(const TileFrame& frame, int left, int bottom) {
    return left + blockSize <= frame.width && bottom + blockSize <= frame.height;
}

inline void fetchPixel(const TileFrame& frame, std::int64_t from, BlockPixels& pixels, int to) {
    pixels.word0[to] = frame.surfaces[2 * from];
    pixels.word1[to] = frame.surfaces[2 * from + 1];
    pixels.depth[to] = frame.depth[from];
}

inline BlockPixels fetchPixels(const TileFrame& frame, int left, int bottom) {
    BlockPixels pixels;
    const bool whole = isWhole(frame, left, bottom);
    for (int row = 0; row < blockSize; ++row) {
        for (int column = 0; column < blockSize; ++column) {
            pixels.x[row * blockSize + column] = static_cast<float>(left + column);
            pixels.y[row * blockSize + column] = static_cast<float>(bottom + row);
        }
        const std::int64_t from = static_cast<std::int64_t>(bottom + row) * frame.width + left;
        if (whole) {
            for (int column = 0; column < blockSize; ++column)
                fetchPixel(frame, from + column, pixels, row * blockSize + column);
            continue;
        }
        for (int column = 0; column < blockSize; ++column) {
            const int to = row * blockSize + column;
            pixels.word1[to] = 0;
            if (left + column < frame.width && bottom + row < frame.height)
                fetchPixel(frame, from + column, pixels, to);
        }
    }
    return pixels;
}

inline Ints loadWords(const std::uint32_t* from) {
    Ints v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}

inline Ints isSurface(const BlockPixels& pixels, int first) {
    return loadWords(pixels.word1 + first) != 0;
}

/// The product of a vector and a number, rounded as shaders/lib/frame.glsl rounds it.
inline Vec3 roundedProduct(Vec3 a, Floats b) {
    return {rounded(a.x * b), rounded(a.y * b), rounded(a.z * b)};
}

inline Vec3 positionOf(const TileFrame& frame, const BlockPixels& pixels, int first) {
    const Vec3 ray = splat3(frame.rayCorner) +
                     roundedProduct(splat3(frame.rayStepX), load(pixels.x + first)) +
                     roundedProduct(splat3(frame.rayStepY), load(pixels.y + first));
    const Floats depth = select(isSurface(pixels, first), load(pixels.depth + first), splat(1.0f));
    return splat3(frame.eye) + roundedProduct(ray, frame.nearPlane / depth);
}

// ---- Boxes
// ----------------------------------------------------------------------------------------------------

/// The box around a block's surfaces: least x, y, z, greatest x, y, z. False when it has none.
inline bool boxOfBlock(const TileFrame& frame, int left, int bottom, float* box) {
    const BlockPixels pixels = fetchPixels(frame, left, bottom);
    const Floats high = splat(nowhere);
    Vec3 low{high, high, high}, negated{high, high, high};
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        const Ints surface = isSurface(pixels, first);
        const Vec3 p = positionOf(frame, pixels, first);
        low = {min(low.x, select(surface, p.x, high)), min(low.y, select(surface, p.y, high)),
               min(low.z, select(surface, p.z, high))};
        negated = {min(negated.x, select(surface, -p.x, high)), min(negated.y, select(surface, -p.y, high)),
                   min(negated.z, select(surface, -p.z, high))};
    }
    box[0] = lowest(low.x), box[1] = lowest(low.y), box[2] = lowest(low.z);
    box[3] = -lowest(negated.x), box[4] = -lowest(negated.y), box[5] = -lowest(negated.z);
    return box[0] < nowhere;
}

inline void joinChildren(TileScratch& scratch, int level, int x, int y) {
    const int side = blocksPerTile >> level, childSide = side * 2;
    float* box = scratch.boxes[level][y * side + x];
    bool& occupied = scratch.occupied[level][y * side + x];
    occupied = false;
    for (int i = 0; i < 3; ++i) box[i] = nowhere, box[i + 3] = -nowhere;
    for (int child = 0; child < 4; ++child) {
        const int at = (2 * y + child / 2) * childSide + 2 * x + child % 2;
        if (!scratch.occupied[level - 1][at]) continue;
        const float* part = scratch.boxes[level - 1][at];
        occupied = true;
        for (int i = 0; i < 3; ++i) {
            box[i] = part[i] < box[i] ? part[i] : box[i];
            box[i + 3] = part[i + 3] > box[i + 3] ? part[i + 3] : box[i + 3];
        }
    }
}

inline void makeBoxes(const TileFrame& frame, int left, int bottom, TileScratch& scratch) {
    for (int y = 0; y < blocksPerTile; ++y) {
        for (int x = 0; x < blocksPerTile; ++x) {
            const int at = y * blocksPerTile + x;
            scratch.occupied[0][at] =
                boxOfBlock(frame, left + x * blockSize, bottom + y * blockSize, scratch.boxes[0][at]);
        }
    }
    for (int level = 1; level < boxLevels; ++level) {
        for (int y = 0; y < blocksPerTile >> level; ++y) {
            for (int x = 0; x < blocksPerTile >> level; ++x) joinChildren(scratch, level, x, y);
        }
    }
}

// ---- Culling
// --------------------------------------------------------------------------------------------------

/// Lists end with a vector of lights that reach nothing, so that whole vectors can be read.
inline void endList(const LightColumns& list, std::uint32_t count) {
    store(list.range2 + count, splat(-1.0f));
}

inline void append(const LightColumns& to, std::uint32_t at, const LightColumns& from, std::uint32_t first,
                   Ints passed, std::uint32_t& count) {
#if defined(__AVX512F__)
    const __mmask16 mask = _mm512_movepi32_mask((__m512i)passed);
    _mm512_mask_compressstoreu_ps(to.x + at, mask, (__m512)load(from.x + first));
    _mm512_mask_compressstoreu_ps(to.y + at, mask, (__m512)load(from.y + first));
    _mm512_mask_compressstoreu_ps(to.z + at, mask, (__m512)load(from.z + first));
    _mm512_mask_compressstoreu_ps(to.range2 + at, mask, (__m512)load(from.range2 + first));
    _mm512_mask_compressstoreu_epi32(to.index + at, mask, (__m512i)loadWords(from.index + first));
    count = at + static_cast<std::uint32_t>(__builtin_popcount(mask));
#else
    count = at;
    for (int lane = 0; lane < laneCount; ++lane) {
        if (passed[lane] == 0) continue;
        const std::uint32_t i = first + static_cast<std::uint32_t>(lane);
        to.x[count] = from.x[i], to.y[count] = from.y[i], to.z[count] = from.z[i];
        to.range2[count] = from.range2[i], to.index[count] = from.index[i];
        ++count;
    }
#endif
}

/// Copies the lights whose sphere meets the box.
inline std::uint32_t filter(const LightColumns& from, std::uint32_t fromCount, const float* box,
                            const LightColumns& to) {
    std::uint32_t count = 0;
    const Floats none = splat(0.0f);
    for (std::uint32_t i = 0; i < fromCount; i += laneCount) {
        const Floats x = load(from.x + i), y = load(from.y + i), z = load(from.z + i);
        const Floats dx = max(max(box[0] - x, x - box[3]), none);
        const Floats dy = max(max(box[1] - y, y - box[4]), none);
        const Floats dz = max(max(box[2] - z, z - box[5]), none);
        append(to, count, from, i, dx * dx + dy * dy + dz * dz < load(from.range2 + i), count);
    }
    endList(to, count);
    return count;
}

/// Reads the lights of a tile into the columns of the uppermost level.
inline void gatherLights(const TileFrame& frame, const std::uint32_t* lights, std::uint32_t count,
                         const LightColumns& to) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t light = lights[i];
        to.x[i] = frame.reach[0][light], to.y[i] = frame.reach[1][light], to.z[i] = frame.reach[2][light];
        to.range2[i] = frame.reach[3][light] * frame.reach[3][light];
        to.index[i] = light;
    }
    endList(to, count);
}

/// The tiles under the light's projection, a pixel wider for rounding; all of them when the light reaches the
/// near plane.
inline VisibleLight tilesUnder(const TileFrame& frame, std::uint32_t index, float x, float y, float depth,
                               float range) {
    const int columns = (frame.width + tileSize - 1) / tileSize,
              rows = (frame.height + tileSize - 1) / tileSize;
    VisibleLight light{index, 0, 0, static_cast<std::uint16_t>(columns - 1),
                       static_cast<std::uint16_t>(rows - 1)};
    if (depth - range <= frame.nearPlane) return light;
    const auto tileAt = [](float share, int pixels, int tiles, float widen) {
        const float pixel = share * static_cast<float>(pixels) + widen;
        if (!(pixel > 0.0f)) return std::uint16_t{0};
        return static_cast<std::uint16_t>(
            pixel < static_cast<float>(tiles * tileSize) ? static_cast<int>(pixel) / tileSize : tiles - 1);
    };
    const float range2 = range * range, scale = 0.5f / (depth * depth - range2);
    const auto reach = [&](float side) {
        const float square = side * side + depth * depth - range2;
        return range * __builtin_sqrtf(square > 0.0f ? square : 0.0f);
    };
    const float scaleX = scale / frame.halfExtent[0], scaleY = scale / frame.halfExtent[1];
    light.left = tileAt(0.5f + (x * depth - reach(x)) * scaleX, frame.width, columns, -1.0f);
    light.right = tileAt(0.5f + (x * depth + reach(x)) * scaleX, frame.width, columns, 1.0f);
    light.bottom = tileAt(0.5f + (y * depth - reach(y)) * scaleY, frame.height, rows, -1.0f);
    light.top = tileAt(0.5f + (y * depth + reach(y)) * scaleY, frame.height, rows, 1.0f);
    return light;
}

std::size_t cull(const TileFrame& frame, std::uint32_t first, std::uint32_t end, VisibleLight* out) {
    std::size_t count = 0;
    for (std::uint32_t i = first; i < end; i += laneCount) {
        // The columns of reaches end with a vector of room, so that the last one may read past the lights.
        const Vec3 way = Vec3{load(frame.reach[0] + i), load(frame.reach[1] + i), load(frame.reach[2] + i)} -
                         splat3(frame.eye);
        const Floats range = load(frame.reach[3] + i);
        const Floats x = dot(way, splat3(frame.right)), y = dot(way, splat3(frame.up)),
                     depth = dot(way, splat3(frame.forward));
        const Ints visible = (depth + range >= frame.nearPlane) &
                             ((absolute(x) - depth * frame.halfExtent[0]) * frame.edgeScale[0] <= range) &
                             ((absolute(y) - depth * frame.halfExtent[1]) * frame.edgeScale[1] <= range);
#if defined(__AVX512F__)
        if (_mm512_movepi32_mask((__m512i)visible) == 0) continue;
#endif
        for (int lane = 0; lane < laneCount; ++lane) {
            const std::uint32_t index = i + static_cast<std::uint32_t>(lane);
            if (visible[lane] == 0 || index >= end) continue;
            out[count++] = tilesUnder(frame, index, x[lane], y[lane], depth[lane], range[lane]);
        }
    }
    return count;
}

// ---- Shading
// --------------------------------------------------------------------------------------------------

inline Floats fold(Floats across, Floats along) {
    return (1.0f - absolute(across)) * select(along >= 0.0f, splat(1.0f), splat(-1.0f));
}

inline Vec3 unpackNormal(Ints word) {
    const Floats x = (__builtin_convertvector(word & 0xfff, Floats) - 2048.0f) * (1.0f / 2047.0f);
    const Floats y = (__builtin_convertvector((word >> 12) & 0xfff, Floats) - 2048.0f) * (1.0f / 2047.0f);
    const Floats z = 1.0f - absolute(x) - absolute(y);
    const Ints lower = z < 0.0f;
    const Vec3 n{select(lower, fold(y, x), x), select(lower, fold(x, y), y), z};
    return n * rsqrt(dot(n, n));
}

inline Surface unpackPixels(const TileFrame& frame, const BlockPixels& pixels, int first) {
    Surface surface;
    surface.position = positionOf(frame, pixels, first);
    const Ints word = loadWords(pixels.word1 + first);
    surface.normal = unpackNormal(word);
    surface.roughness = __builtin_convertvector((word >> 24) & 0xff, Floats) * (1.0f / 255.0f);
    const Ints color = loadWords(pixels.word0 + first);
    surface.baseColor = {lookUp(frame.srgbDecode, color & 0xff),
                         lookUp(frame.srgbDecode, (color >> 8) & 0xff),
                         lookUp(frame.srgbDecode, (color >> 16) & 0xff)};
    surface.metallic = __builtin_convertvector((color >> 24) & 0xff, Floats) * (1.0f / 255.0f);
    return surface;
}

inline void addPixel(const TileFrame& frame, std::int64_t at, Four radiance) {
    Four sum;
    __builtin_memcpy(&sum, frame.radiance + 4 * at, sizeof sum);
    sum += radiance;
    __builtin_memcpy(frame.radiance + 4 * at, &sum, sizeof sum);
}

/// Adds what `laneCount` pixels of the block, from `first` on, receive.
inline void addRadiance(const TileFrame& frame, const BlockPixels& pixels, int left, int bottom, int first,
                        Vec3 sum) {
    const Ints surface = isSurface(pixels, first);
    const Vec3 kept{select(surface, sum.x, Floats{}), select(surface, sum.y, Floats{}),
                    select(surface, sum.z, Floats{})};
    const bool whole = isWhole(frame, left, bottom);
    for (int lane = 0; lane < laneCount; lane += blockSize) {
        const int row = bottom + (first + lane) / blockSize;
        const std::int64_t at = static_cast<std::int64_t>(row) * frame.width + left;
        const Four x = fourOf(kept.x, lane), y = fourOf(kept.y, lane), z = fourOf(kept.z, lane);
        for (int column = 0; column < blockSize; ++column) {
            if (!whole && (row >= frame.height || left + column >= frame.width)) break;
            addPixel(frame, at + column, Four{x[column], y[column], z[column], 0.0f});
        }
    }
}

template <Model model>
void shadeBlock(const TileFrame& frame, int left, int bottom, const std::uint32_t* lights,
                std::uint32_t count) {
    const BlockPixels pixels = fetchPixels(frame, left, bottom);
    std::uint32_t points = count;
    while (points > 0 && lights[points - 1] >= frame.pointCount) --points;
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        const ShadingPoint point = shadingPoint<model>(frame, unpackPixels(frame, pixels, first));
        Vec3 sum{};
        for (std::uint32_t i = 0; i < points; ++i)
            sum = sum + localLight<model>(point, frame.records + 8 * std::uint64_t{lights[i]}, nullptr);
        for (std::uint32_t i = points; i < count; ++i) {
            const float* cone = frame.cones + 4 * std::uint64_t{lights[i] - frame.pointCount};
            sum = sum + localLight<model>(point, frame.records + 8 * std::uint64_t{lights[i]}, cone);
        }
        for (std::uint32_t i = 0; i < frame.directionalCount; ++i) {
            sum = sum +
                  directionalLight<model>(point, frame.records + 8 * (std::uint64_t{frame.localCount} + i));
        }
        addRadiance(frame, pixels, left, bottom, first, sum);
    }
}

/// The node of the box tree at `level`, with the lights that met its parent.
template <Model model>
void shadeNode(const TileFrame& frame, int left, int bottom, int level, int x, int y,
               std::uint32_t parentCount, TileScratch& scratch) {
    const int side = blocksPerTile >> level, at = y * side + x;
    if (!scratch.occupied[level][at]) return;
    const LightColumns& list = scratch.levels[level];
    const std::uint32_t count =
        filter(scratch.levels[level + 1], parentCount, scratch.boxes[level][at], list);
    if (count == 0 && frame.directionalCount == 0) return;
    if (level > 0) {
        for (int child = 0; child < 4; ++child) {
            shadeNode<model>(frame, left, bottom, level - 1, 2 * x + child % 2, 2 * y + child / 2, count,
                             scratch);
        }
        return;
    }
    scratch.pairsEvaluated += std::uint64_t{count} * pixelsPerBlock;
    shadeBlock<model>(frame, left + x * blockSize, bottom + y * blockSize, list.index, count);
}

/// Asks for the tile's part of the G-buffer ahead of its use: blocks read a few bytes of many rows, which the
/// processor does not foresee.
void prefetchTile(const TileFrame& frame, int left, int bottom) {
    constexpr int pixelsPerLine = 64 / (2 * sizeof(std::uint32_t));
    for (int y = bottom; y < bottom + tileSize && y < frame.height; ++y) {
        const std::int64_t at = static_cast<std::int64_t>(y) * frame.width + left;
        for (int x = 0; x < tileSize; x += pixelsPerLine) {
            __builtin_prefetch(frame.surfaces + 2 * (at + x));
            if (x % (2 * pixelsPerLine) == 0) __builtin_prefetch(frame.depth + at + x);
        }
    }
}

void clearTile(const TileFrame& frame, int left, int bottom) {
    const int width = frame.width - left < tileSize ? frame.width - left : tileSize;
    for (int y = bottom; y < bottom + tileSize && y < frame.height; ++y) {
        float* row = frame.radiance + 4 * (static_cast<std::int64_t>(y) * frame.width + left);
        __builtin_memset(row, 0, static_cast<std::size_t>(width) * 4 * sizeof(float));
    }
}

template <Model model>
void shade(const TileFrame& frame, int tileX, int tileY, const std::uint32_t* lights, std::uint32_t count,
           TileScratch& scratch) {
    const int left = tileX * tileSize, bottom = tileY * tileSize;
    if (!frame.keepsEmission) clearTile(frame, left, bottom);
    if (count == 0 && frame.directionalCount == 0) return;
    prefetchTile(frame, left, bottom);
    makeBoxes(frame, left, bottom, scratch);
    gatherLights(frame, lights, count, scratch.levels[boxLevels]);
    shadeNode<model>(frame, left, bottom, boxLevels - 1, 0, 0, count, scratch);
}

}  // namespace

extern const TileKernel CANDELA_TILE_KERNEL;
const TileKernel CANDELA_TILE_KERNEL{
    CANDELA_TILE_KERNEL_NAME, cull, {shade<Model::course>, shade<Model::gltf>}};

}  // namespace candela
