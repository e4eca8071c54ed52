#pragma once

// The light equation (shaders/shared/shading.h) and the light bounds (shaders/shared/light_bounds.h) over
// vectors of floats, and the pixels of a block as they read them. Included only by tile_kernel_code.h.

#include "render/lighting/tiled/tile_kernel.h"
#include "render/simd.h"

namespace candela {
namespace {

using Real = Floats;
using Real3 = Vec3;
using Scalar = float;
#define SHARED_FUNCTION __attribute__((always_inline)) inline
#define precise  // a qualifier of GLSL

// Scalars, for the bounds of one light. No function of <cmath> has internal linkage.
inline float sqrt(float a) {
    return __builtin_sqrtf(a);
}
inline float max(float a, float b) {
    return a > b ? a : b;
}

struct AlbedoTable {
    const float* texels;
    int size;
};

inline Floats fastDivide(Floats a, Floats b) {
    return a * reciprocal(b);
}

#include "shared/shading_constants.h"
#include "shared/surface_lobes.h"

inline Floats signOf(Floats a) {
    return select(a < 0.0f, splat(-1.0f), splat(1.0f));
}

/// As in shaders/lib/environment.glsl.
inline Floats octavesBelowOne(Floats a) {
    constexpr std::int32_t one = 0x3f800000;
    return __builtin_convertvector(one - (Ints)a, Floats) * (1.0f / 8388608.0f);
}

inline bool anyAbove(Floats a) {
    return minOfLanes(-a) < 0.0f;
}

inline Floats whereAbove(Floats x, Floats a, Floats b) {
    return select(x > 0.0f, a, b);
}

#include "shared/light_bounds.h"
#include "shared/shading.h"

// These read `ShadingPoint` of shading.h.
#include "shared/extended_lobes.h"
#include "shared/shadow_ray.h"

#include "shared/environment.h"

// Reads what the last two declare.
#include "shared/extended_environment.h"

/// As shaders/lib/lighting.glsl reads the table. Two neighbouring texels are one load of four floats, which
/// is faster than to gather each number.
SHARED_FUNCTION AlbedoTexel readAlbedoTable(AlbedoTable table, Floats x, Floats y) {
    const float last = static_cast<float>(table.size - 1);
    const Floats column = x * last, row = y * last;
    // `min` gives its second argument where the first is not a number: no pixel reads outside of the table.
    const Ints i = __builtin_convertvector(min(column, last - 1.0f), Ints);
    const Ints j = __builtin_convertvector(min(row, last - 1.0f), Ints);
    const Ints cell = 2 * (j * table.size + i);
    const Floats weightX = column - __builtin_convertvector(i, Floats),
                 weightY = row - __builtin_convertvector(j, Floats);
    Four columns[4][laneCount / 4];  // albedo and cosine on the left, then on the right
    for (int part = 0; part < laneCount / 4; ++part) {
        Four rows[4];
        for (int k = 0; k < 4; ++k) {
            const int lane = 4 * part + k;
            const float* texels = table.texels + cell[lane];
            const Four low = loadFour(texels), high = loadFour(texels + 2 * table.size);
            rows[k] = low + (high - low) * weightY[lane];
        }
        transpose(rows[0], rows[1], rows[2], rows[3]);
        for (int k = 0; k < 4; ++k) columns[k][part] = rows[k];
    }
    const auto between = [&](int left, int right) {
        const Floats low = joined(columns[left]);
        return low + (joined(columns[right]) - low) * weightX;
    };
    return {between(0, 2), between(1, 3)};
}

// ---- Light records, as GpuLights writes them

inline LocalLight localLightOf(const float* record) {
    return {splat3(record), splat(record[3]), splat3(record + 4)};
}

inline LightCone lightConeOf(const float* record) {
    return {splat3(record), splat(record[3])};
}

// ---- Pixels

constexpr int pixelsPerBlock = blockSize * blockSize;

/// The pixels of a block, row by row; those outside of the picture read as background.
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

/// The pixels of a block that lies in the picture.
inline void fetchWhole(const TileFrame& frame, std::int64_t from, BlockPixels& pixels) {
    static_assert(blockSize == 4);
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        Four word0[laneCount / blockSize], word1[laneCount / blockSize], depth[laneCount / blockSize];
        for (int row = 0; row < laneCount / blockSize; ++row, from += frame.width) {
            const auto words = reinterpret_cast<const float*>(frame.surfaces + 2 * from);
            const Four low = loadFour(words), high = loadFour(words + 4);
            word0[row] = __builtin_shufflevector(low, high, 0, 2, 4, 6);
            word1[row] = __builtin_shufflevector(low, high, 1, 3, 5, 7);
            depth[row] = loadFour(frame.depth + from);
        }
        const Floats all0 = joined(word0), all1 = joined(word1);
        __builtin_memcpy(pixels.word0 + first, &all0, sizeof all0);
        __builtin_memcpy(pixels.word1 + first, &all1, sizeof all1);
        store(pixels.depth + first, joined(depth));
    }
}

inline BlockPixels fetchPixels(const TileFrame& frame, int left, int bottom) {
    BlockPixels pixels;
    for (int i = 0; i < pixelsPerBlock; ++i) {
        pixels.x[i] = static_cast<float>(left + i % blockSize);
        pixels.y[i] = static_cast<float>(bottom + i / blockSize);
    }
    if (isWhole(frame, left, bottom)) {
        fetchWhole(frame, static_cast<std::int64_t>(bottom) * frame.width + left, pixels);
        return pixels;
    }
    for (int i = 0; i < pixelsPerBlock; ++i) {
        const int x = left + i % blockSize, y = bottom + i / blockSize;
        pixels.word1[i] = 0;
        if (x < frame.width && y < frame.height)
            fetchPixel(frame, static_cast<std::int64_t>(y) * frame.width + x, pixels, i);
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

/// As `worldPosition` of shaders/lib/frame.glsl.
inline Vec3 positionOf(const TileFrame& frame, const BlockPixels& pixels, int first) {
    const Vec3 ray = splat3(frame.rayCorner) +
                     roundedProduct(splat3(frame.rayStepX), load(pixels.x + first)) +
                     roundedProduct(splat3(frame.rayStepY), load(pixels.y + first));
    const Floats depth = select(isSurface(pixels, first), load(pixels.depth + first), splat(1.0f));
    if (frame.orthographic) {
        const Floats distance = frame.farPlane - rounded(depth * frame.depthRange);
        return splat3(frame.eye) + ray + roundedProduct(splat3(frame.forward), distance);
    }
    return splat3(frame.eye) +
           roundedProduct(ray, frame.nearPlane / (rounded(depth * frame.depthScale) + frame.nearOverFar));
}

/// As `wayToEye` of shaders/lib/frame.glsl.
inline Vec3 wayToEye(const TileFrame& frame, Vec3 position) {
    if (frame.orthographic) return Vec3(0.0f) - splat3(frame.forward);
    return splat3(frame.eye) - position;
}

// The encoding of shaders/shared/gbuffer_encoding.h.

inline Floats octahedralFold(Floats across, Floats along) {
    return (1.0f - abs(across)) * select(along >= 0.0f, splat(1.0f), splat(-1.0f));
}

inline Vec3 unpackNormal(Ints word1) {
    const Floats x = (__builtin_convertvector(word1 & 0xfff, Floats) - 2048.0f) * (1.0f / 2047.0f);
    const Floats y = (__builtin_convertvector((word1 >> 12) & 0xfff, Floats) - 2048.0f) * (1.0f / 2047.0f);
    const Floats z = 1.0f - abs(x) - abs(y);
    const Ints lower = z < 0.0f;
    const Vec3 n{select(lower, octahedralFold(y, x), x), select(lower, octahedralFold(x, y), y), z};
    return n * inversesqrt(dot(n, n));
}

inline Floats unpackRoughness(Ints code) {
    constexpr float step = 2.2767854e-3f;  // ROUGHNESS_STEP
    const Floats root = 1.0f - rounded(__builtin_convertvector(255 - code, Floats) * step);
    return select(code == 0, splat(0.0f), root * root * (root * root));
}

/// The sRGB-encoded colour of the lower three bytes.
inline Vec3 unpackColor(const TileFrame& frame, Ints word) {
    const float* table = frame.srgbDecode;
    const std::int32_t first = word[0];
    // Mostly true without textures; to look up each lane takes as long as several lights.
    const bool isOneColor = laneBits(word != first) == 0;
    if (isOneColor)
        return {splat(table[first & 0xff]), splat(table[first >> 8 & 0xff]),
                splat(table[first >> 16 & 0xff])};
    return {lookUp(table, word & 0xff), lookUp(table, word >> 8 & 0xff), lookUp(table, word >> 16 & 0xff)};
}

inline SurfaceLobes unpackLobes(const TileFrame& frame, Ints word0, Ints word1) {
    SurfaceLobes lobes;
    lobes.baseColor = unpackColor(frame, word0);
    lobes.metallic = __builtin_convertvector((word0 >> 24) & 0xff, Floats) * (1.0f / 255.0f);
    lobes.roughness = unpackRoughness((word1 >> 24) & 0xff);
    return lobes;
}

// ---- Shading

/// Writes what `laneCount` pixels of the block, from `first` on, receive, or adds it to what is there.
inline void putRadiance(const TileFrame& frame, const BlockPixels& pixels, int left, int bottom, int first,
                        Vec3 sum) {
    const Ints surface = isSurface(pixels, first);
    const Vec3 kept{select(surface, sum.x, Floats{}), select(surface, sum.y, Floats{}),
                    select(surface, sum.z, Floats{})};
    const int columns = frame.width - left < blockSize ? frame.width - left : blockSize;
    for (int lane = 0; lane < laneCount; lane += blockSize) {
        const int row = bottom + (first + lane) / blockSize;
        if (row >= frame.height) break;
        Four colors[4] = {fourOf(kept.x, lane), fourOf(kept.y, lane), fourOf(kept.z, lane), Four{}};
        transpose(colors[0], colors[1], colors[2], colors[3]);
        float* to = frame.radiance + 4 * (static_cast<std::int64_t>(row) * frame.width + left);
        for (int column = 0; column < columns; ++column) {
            if (frame.loadRadiance) colors[column] += loadFour(to + 4 * column);
            __builtin_memcpy(to + 4 * column, &colors[column], sizeof(Four));
        }
    }
}

/// Writes 0 to a square of `size` pixels that nothing lights. Where radiance is added, it stays as it is.
inline void leaveUnlit(const TileFrame& frame, int left, int bottom, int size) {
    if (frame.loadRadiance) return;
    const int width = frame.width - left < size ? frame.width - left : size;
    if (width <= 0) return;
    for (int y = bottom; y < bottom + size && y < frame.height; ++y) {
        float* row = frame.radiance + 4 * (static_cast<std::int64_t>(y) * frame.width + left);
        __builtin_memset(row, 0, static_cast<std::size_t>(width) * 4 * sizeof(float));
    }
}

template <int brdf>
inline ShadingPoint shadingPointAt(const TileFrame& frame, const BlockPixels& pixels, int first) {
    const Ints word0 = loadWords(pixels.word0 + first), word1 = loadWords(pixels.word1 + first);
    const Vec3 position = positionOf(frame, pixels, first);
    return shadingPoint(brdf, unpackLobes(frame, word0, word1), unpackNormal(word1), position,
                        wayToEye(frame, position), {frame.albedoTable, frame.albedoTableSize});
}

}  // namespace
}  // namespace candela
