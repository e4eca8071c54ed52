#pragma once

// The kernels of the technique `tiles` on the CPU. Each render/kernels_*.cpp includes this once and is
// compiled for its own instruction set, with CANDELA_TILE_KERNEL naming the table it defines. Everything here
// has internal linkage, and no inline function of a library is used: the linker keeps only one copy of an
// inline function, which may be compiled for an instruction set that the processor lacks.

#include "render/lighting/tiled/tile_kernel.h"

#include "render/lighting/tiled/tile_environment.h"
#include "render/lighting/tiled/tile_hemispheres.h"
#include "render/lighting/tiled/tile_lobes.h"
#include "render/lighting/tiled/tile_shading.h"
#include "render/lighting/tiled/tile_visible.h"

namespace candela {
namespace {

constexpr int blocksPerTile = tileSize / blockSize;

// ---- Boxes

/// The box around a block's surfaces: minimum x, y, z, maximum x, y, z. False when it has none.
inline bool boxOfBlock(const TileFrame& frame, int left, int bottom, float* box) {
    const BlockPixels pixels = fetchPixels(frame, left, bottom);
    const Floats high = splat(infinity);
    Vec3 low{high, high, high}, negated{high, high, high};
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        const Ints surface = isSurface(pixels, first);
        const Vec3 p = positionOf(frame, pixels, first);
        low = {min(low.x, select(surface, p.x, high)), min(low.y, select(surface, p.y, high)),
               min(low.z, select(surface, p.z, high))};
        negated = {min(negated.x, select(surface, -p.x, high)), min(negated.y, select(surface, -p.y, high)),
                   min(negated.z, select(surface, -p.z, high))};
    }
    box[0] = minOfLanes(low.x), box[1] = minOfLanes(low.y), box[2] = minOfLanes(low.z);
    box[3] = -minOfLanes(negated.x), box[4] = -minOfLanes(negated.y), box[5] = -minOfLanes(negated.z);
    return box[0] < infinity;
}

inline void joinChildren(TileScratch& scratch, int level, int x, int y) {
    const int side = blocksPerTile >> level, childSide = side * 2;
    float* box = scratch.boxes[level][y * side + x];
    bool& occupied = scratch.occupied[level][y * side + x];
    occupied = false;
    for (int i = 0; i < 3; ++i) box[i] = infinity, box[i + 3] = -infinity;
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

/// Pads a list with a vector of lights of no range, so that whole vectors can be read.
inline void endList(const LightColumns& list, std::uint32_t count) {
    store(list.range2 + count, splat(-1.0f));
}

#if defined(__AVX2__) && !defined(__AVX512F__)
/// For each set of lanes, a bit each, their numbers one after the other.
struct LaneOrders {
    std::uint8_t lanes[1 << laneCount][laneCount];
};

constexpr LaneOrders makeLaneOrders() {
    LaneOrders orders{};
    for (int set = 0; set < 1 << laneCount; ++set) {
        int count = 0;
        for (int lane = 0; lane < laneCount; ++lane) {
            if ((set >> lane & 1) != 0) orders.lanes[set][count++] = static_cast<std::uint8_t>(lane);
        }
    }
    return orders;
}

constexpr LaneOrders laneOrders = makeLaneOrders();
#endif

inline void append(const LightColumns& to, std::uint32_t at, const LightColumns& from, std::uint32_t first,
                   Ints passed, std::uint32_t& count) {
#if defined(__AVX512F__)
    const __mmask16 mask = _mm512_movepi32_mask((__m512i)passed);
    // Compressed in a register, and whole vectors are written, as below: a compressing store takes more than
    // a hundred cycles on Zen 4.
    const auto move = [&](float* target, const float* source) {
        _mm512_storeu_ps(target + at, _mm512_maskz_compress_ps(mask, (__m512)load(source + first)));
    };
    move(to.x, from.x), move(to.y, from.y), move(to.z, from.z), move(to.range2, from.range2);
    move(reinterpret_cast<float*>(to.index), reinterpret_cast<const float*>(from.index));
    count = at + static_cast<std::uint32_t>(__builtin_popcount(mask));
#elif defined(__AVX2__)
    const std::uint32_t set = laneBits(passed);
    long long bytes;
    __builtin_memcpy(&bytes, laneOrders.lanes[set], sizeof bytes);
    const __m256i order = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(bytes));
    // Lists have room for a vector more, as `endList` needs it.
    const auto move = [&](float* target, const float* source) {
        _mm256_storeu_ps(target + at, _mm256_permutevar8x32_ps((__m256)load(source + first), order));
    };
    move(to.x, from.x), move(to.y, from.y), move(to.z, from.z), move(to.range2, from.range2);
    move(reinterpret_cast<float*>(to.index), reinterpret_cast<const float*>(from.index));
    count = at + static_cast<std::uint32_t>(__builtin_popcount(set));
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

/// Copies the lights of a tile into the columns of the top level.
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

inline VisibleLight visibleLight(std::uint32_t index, const TileRange& tiles) {
    const auto narrow = [](int tile) { return static_cast<std::uint16_t>(tile); };
    return {index, narrow(tiles.left), narrow(tiles.bottom), narrow(tiles.right), narrow(tiles.top)};
}

std::size_t cull(const TileFrame& frame, std::uint32_t first, std::uint32_t end, VisibleLight* out) {
    const TileGrid grid{frame.width, frame.height, tileSize, (frame.width + tileSize - 1) / tileSize,
                        (frame.height + tileSize - 1) / tileSize};
    const ViewFrustum frustum{frame.nearPlane,
                              frame.halfExtent[0],
                              frame.halfExtent[1],
                              edgeScale(frame.halfExtent[0], frame.shift[0]),
                              edgeScale(frame.halfExtent[1], frame.shift[1]),
                              frame.base[0],
                              frame.base[1],
                              frame.shift[0],
                              frame.shift[1]};
    std::size_t count = 0;
    for (std::uint32_t i = first; i < end; i += laneCount) {
        // The columns of `reach` end with padding, so that the last vector may read past the lights.
        const Vec3 way = Vec3{load(frame.reach[0] + i), load(frame.reach[1] + i), load(frame.reach[2] + i)} -
                         splat3(frame.eye);
        const Floats range = load(frame.reach[3] + i);
        const Floats x = dot(way, splat3(frame.right)), y = dot(way, splat3(frame.up)),
                     depth = dot(way, splat3(frame.forward));
        std::uint32_t visible = laneBits(distanceToFrustum(frustum, x, y, depth) <= range);
        for (; visible != 0; visible &= visible - 1) {
            const int lane = __builtin_ctz(visible);
            const std::uint32_t index = i + static_cast<std::uint32_t>(lane);
            if (index >= end) break;
            out[count++] =
                visibleLight(index, tilesUnder(grid, frustum, x[lane], y[lane], depth[lane], range[lane]));
        }
    }
    return count;
}

// ---- Shading

template <int brdf>
void shadeBlock(const TileFrame& frame, int left, int bottom, const std::uint32_t* lights,
                std::uint32_t count) {
    const BlockPixels pixels = fetchPixels(frame, left, bottom);
    std::uint32_t points = count;
    while (points > 0 && lights[points - 1] >= frame.pointCount) --points;
    const auto recordOf = [&](std::uint64_t light) { return frame.records + 8 * light; };
    const std::uint32_t extended =
        frame.lobeWords == nullptr ? 0 : shadeLobes<brdf>(frame, left, bottom, lights, count);
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        if ((extended >> first & 1) != 0) continue;
        const ShadingPoint point = shadingPointAt<brdf>(frame, pixels, first);
        Vec3 sum = environmentLight(frame, point, left, bottom, first);
        for (std::uint32_t i = 0; i < points; ++i)
            sum = sum + pointLightRadiance(brdf, point, localLightOf(recordOf(lights[i])));
        for (std::uint32_t i = points; i < count; ++i) {
            const float* cone = frame.cones + 4 * std::uint64_t{lights[i] - frame.pointCount};
            sum = sum + spotLightRadiance(brdf, point, localLightOf(recordOf(lights[i])), lightConeOf(cone));
        }
        for (std::uint32_t i = 0; i < frame.directionalCount; ++i) {
            const float* record = recordOf(std::uint64_t{frame.localCount} + i);
            sum = sum + directionalLightRadiance(brdf, point, splat3(record), splat3(record + 4));
        }
        putRadiance(frame, pixels, left, bottom, first, sum);
    }
}

/// As `shadeBlock`, for the lights of `slots`, with shadows.
template <int brdf>
void shadeBlockWithShadows(const TileFrame& frame, int left, int bottom, const std::uint32_t* slots,
                           std::uint32_t count, ShadowScratch& scratch) {
    const BlockPixels pixels = fetchPixels(frame, left, bottom);
    LobeSides sides;
    std::uint32_t extended = 0;
    if (findVisibleOf<brdf>(frame, pixels, left, bottom, slots, count, scratch, sides) != nullptr) {
        extended = sides.lobes.vectors;
        shadeExtended<brdf>(frame, sides.lobes, left, bottom, slots, count, &scratch);
    }
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        if ((extended >> first & 1) != 0) continue;
        const ShadingPoint point = shadingPointAt<brdf>(frame, pixels, first);
        constexpr std::uint32_t group = (1u << (laneCount - 1) << 1) - 1;
        Vec3 sum = environmentLight(frame, point, left, bottom, first);
        // The intensity is masked, not the radiance: the sum is then contracted as that of `shadeBlock`, and
        // the image where nothing is hidden is the same bit for bit.
        const auto visiblePart = [&](std::uint32_t i, Vec3 intensity) {
            if (scratch.dimmed[i] != 0)
                return intensity * load(scratch.transmittance + std::uint64_t{i} * raysPerBlock + first);
            const bool partly = (scratch.hidden[i] >> first & group) != 0;
            return partly ? masked(intensity, lanesOf(scratch.visible[i], first)) : intensity;
        };
        for (std::uint32_t i = 0; i < count; ++i) {
            if ((scratch.visible[i] >> first & group) == 0) continue;
            const std::uint32_t light = scratch.lightOfSlot[slots[i]];
            LocalLight local = localLightOf(frame.records + 8 * std::uint64_t{light});
            local.intensity = visiblePart(i, local.intensity);
            if (light < frame.pointCount) {
                sum = sum + pointLightRadiance(brdf, point, local);
            } else {
                const float* cone = frame.cones + 4 * std::uint64_t{light - frame.pointCount};
                sum = sum + spotLightRadiance(brdf, point, local, lightConeOf(cone));
            }
        }
        for (std::uint32_t i = 0; i < frame.directionalCount; ++i) {
            if ((scratch.visible[count + i] >> first & group) == 0) continue;
            const float* record = frame.records + 8 * (std::uint64_t{frame.localCount} + i);
            sum = sum + directionalLightRadiance(brdf, point, splat3(record),
                                                 visiblePart(count + i, splat3(record + 4)));
        }
        putRadiance(frame, pixels, left, bottom, first, sum);
    }
}

/// Adds the number of lights, of the slots and directional ones, that are hidden from each pixel of the
/// block.
template <int brdf>
void countShadowed(const TileFrame& frame, int left, int bottom, const std::uint32_t* slots,
                   std::uint32_t count, ShadowScratch& scratch) {
    const BlockPixels pixels = fetchPixels(frame, left, bottom);
    LobeSides sides;
    findVisibleOf<brdf>(frame, pixels, left, bottom, slots, count, scratch, sides);
    for (int i = 0; i < pixelsPerBlock; ++i) {
        const int x = left + i % blockSize, y = bottom + i / blockSize;
        if (x >= frame.width || y >= frame.height) continue;
        std::uint32_t hidden = 0;
        for (std::uint32_t light = 0; light < count + frame.directionalCount; ++light)
            hidden += scratch.hidden[light] >> i & 1u;
        frame.shadowedCounts[static_cast<std::int64_t>(y) * frame.width + x] += static_cast<float>(hidden);
    }
}

/// Whether anything lights pixels that `count` point and spot lights may reach.
inline bool hasLight(const TileFrame& frame, std::uint32_t count) {
    return count > 0 || frame.directionalCount > 0 || frame.environment != nullptr;
}

/// The node of the box tree at `level`, with the lights that met its parent.
template <int brdf>
void shadeNode(const TileFrame& frame, int left, int bottom, int level, int x, int y,
               std::uint32_t parentCount, TileScratch& scratch) {
    const int side = blocksPerTile >> level, at = y * side + x;
    const int nodeLeft = left + (x * blockSize << level), nodeBottom = bottom + (y * blockSize << level);
    const int size = blockSize << level;
    if (!scratch.occupied[level][at]) return leaveUnlit(frame, nodeLeft, nodeBottom, size);
    const LightColumns& list = scratch.levels[level];
    const std::uint32_t count =
        filter(scratch.levels[level + 1], parentCount, scratch.boxes[level][at], list);
    if (!hasLight(frame, count)) return leaveUnlit(frame, nodeLeft, nodeBottom, size);
    if (level == shadowLevel && frame.occlusion != nullptr) {
        fillSlots(frame, endBoxOf(frame, nodeLeft, nodeBottom, 1 << level), list, count, scratch.shadows);
    }
    if (level > 0) {
        for (int child = 0; child < 4; ++child) {
            shadeNode<brdf>(frame, left, bottom, level - 1, 2 * x + child % 2, 2 * y + child / 2, count,
                            scratch);
        }
        return;
    }
    scratch.pairsEvaluated += std::uint64_t{count} * pixelsPerBlock;
    if (frame.shadowedCounts != nullptr) {
        countShadowed<brdf>(frame, nodeLeft, nodeBottom, list.index, count, scratch.shadows);
    } else if (frame.occlusion != nullptr) {
        shadeBlockWithShadows<brdf>(frame, nodeLeft, nodeBottom, list.index, count, scratch.shadows);
    } else {
        shadeBlock<brdf>(frame, nodeLeft, nodeBottom, list.index, count);
    }
}

/// Prefetches the tile's part of the G-buffer: blocks read a few bytes of many rows, a pattern that the
/// processor's own prefetcher does not follow.
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

template <int brdf>
void shade(const TileFrame& frame, int tileX, int tileY, const std::uint32_t* lights, std::uint32_t count,
           TileScratch& scratch) {
    const int left = tileX * tileSize, bottom = tileY * tileSize;
    if (!hasLight(frame, count)) return leaveUnlit(frame, left, bottom, tileSize);
    prefetchTile(frame, left, bottom);
    if (count == 0 && frame.directionalCount == 0) {
        reflectInTile<brdf>(frame, left, bottom);
        return;
    }
    makeBoxes(frame, left, bottom, scratch);
    gatherLights(frame, lights, count, scratch.levels[boxLevels]);
    shadeNode<brdf>(frame, left, bottom, boxLevels - 1, 0, 0, count, scratch);
}

}  // namespace

extern const TileKernel CANDELA_TILE_KERNEL;
const TileKernel CANDELA_TILE_KERNEL{
    CANDELA_KERNEL_NAME, cull, {shade<BRDF_COURSE>, shade<BRDF_GLTF>}, readHemispheres, aimRays};

}  // namespace candela
