#pragma once

// Where the rays that find the visibility of an environment start, over vectors of pixels. Included only by
// tile_kernel_code.h.

#include "render/lighting/tiled/tile_shadows.h"
#include "render/occlusion/hemisphere_block.h"
#include "render/occlusion/ray_packet.h"

namespace candela {
namespace {

static_assert(HemisphereBlock::size == pixelsPerBlock && RayPacket::size == pixelsPerBlock);

/// Every `step`th pixel of rows and columns from (left, bottom) on; `words` get their shadow words.
inline BlockPixels fetchSparse(const TileFrame& frame, int left, int bottom, int step, std::uint32_t* words) {
    BlockPixels pixels;
    for (int i = 0; i < pixelsPerBlock; ++i) {
        const int x = left + step * (i % blockSize), y = bottom + step * (i / blockSize);
        pixels.x[i] = static_cast<float>(x), pixels.y[i] = static_cast<float>(y);
        pixels.word1[i] = words[i] = 0;
        if (x >= frame.width || y >= frame.height) continue;
        const std::int64_t from = static_cast<std::int64_t>(y) * frame.width + x;
        fetchPixel(frame, from, pixels, i);
        words[i] = frame.shadowWords[from];
    }
    return pixels;
}

inline void storeColumns(float (*columns)[pixelsPerBlock], int first, const Vec3& v) {
    store(columns[0] + first, v.x), store(columns[1] + first, v.y), store(columns[2] + first, v.z);
}

inline Vec3 loadColumns(const float (*columns)[pixelsPerBlock], int first) {
    return {load(columns[0] + first), load(columns[1] + first), load(columns[2] + first)};
}

inline Vec3 selected(Ints mask, const Vec3& v) {
    return {select(mask, v.x, Floats{}), select(mask, v.y, Floats{}), select(mask, v.z, Floats{})};
}

/// As `tangentsOf` of shaders/shared/environment_ray.h.
inline void storeTangents(HemisphereBlock& block, int first, const Vec3& n) {
    const Floats side = select(n.z < 0.0f, splat(-1.0f), splat(1.0f));
    const Floats a = -1.0f / (side + n.z), b = n.x * n.y * a;
    storeColumns(block.tangents[0], first, {1.0f + side * n.x * n.x * a, side * b, -side * n.x});
    storeColumns(block.tangents[1], first, {b, side + n.y * n.y * a, -n.y});
}

void readHemispheres(const TileFrame& frame, int left, int bottom, int step, HemisphereBlock& block) {
    std::uint32_t words[pixelsPerBlock];
    const BlockPixels pixels = fetchSparse(frame, left, bottom, step, words);
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        const Ints surface = isSurface(pixels, first), word = loadWords(words + first);
        const Vec3 position = positionOf(frame, pixels, first);
        const Vec3 geometric = unpackGeometricNormal(word);
        const Floats extent = pixelExtent(frame, position);
        const Vec3 normal = unpackNormal(loadWords(pixels.word1 + first));
        storeColumns(block.origin, first,
                     shadowRayEnd(position, wayToEye(frame, position), geometric, halfToFloat(word), extent));
        storeColumns(block.normal, first, normal);
        storeTangents(block, first, normal);
        storeColumns(block.geometricNormal, first, selected(surface, geometric));
        storeColumns(block.position, first, selected(surface, position - splat3(frame.eye)));
        store(block.extent + first, select(surface, extent, Floats{}));
        __builtin_memcpy(block.active + first, &surface, sizeof surface);
    }
}

/// As `aboveTriangle` of shaders/shared/environment_ray.h.
inline Vec3 aboveTriangle(const Vec3& direction, const Vec3& geometricNormal) {
    constexpr float minElevation = 0.02f;  // MIN_RAY_ELEVATION
    const Floats height = dot(direction, geometricNormal);
    const Floats missing = max(abs(height), minElevation) - height;
    return direction + geometricNormal * select(height < minElevation, missing, Floats{});
}

void aimRays(const HemisphereBlock& block, const float* direction, float distance, RayPacket& packet) {
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        const Vec3 way = loadColumns(block.tangents[0], first) * splat(direction[0]) +
                         loadColumns(block.tangents[1], first) * splat(direction[1]) +
                         loadColumns(block.normal, first) * splat(direction[2]);
        storeColumns(packet.origin, first, loadColumns(block.origin, first));
        storeColumns(packet.direction, first, aboveTriangle(way, loadColumns(block.geometricNormal, first)));
        store(packet.tMin + first, Floats{});
        store(packet.tMax + first, splat(distance));
    }
    __builtin_memcpy(packet.active, block.active, sizeof packet.active);
}

}  // namespace
}  // namespace candela
