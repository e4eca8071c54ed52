#pragma once

// The light of the environment (shaders/shared/environment.h) over vectors of pixels. Included only by
// tile_kernel_code.h.

#include "render/lighting/tiled/tile_shading.h"

namespace candela {
namespace {

/// Where pixels read a map: four texels around a point, and the weights of the later ones.
struct MapCells {
    std::int32_t above[laneCount], below[laneCount];  ///< Floats of `EnvironmentView::texels`.
    float weightX[laneCount], weightY[laneCount];

    /// The point's numbers that are none become 0. `firstTexel` and `size` are whole numbers.
    MapCells(MapPoint point, Floats firstTexel, Floats size) {
        const Floats x = min(max(point.u, 0.0f), 1.0f) * (size - 1.0f),
                     y = min(max(point.v, 0.0f), 1.0f) * (size - 1.0f);
        const Ints column = __builtin_convertvector(min(x, size - 2.0f), Ints),
                   row = __builtin_convertvector(min(y, size - 2.0f), Ints);
        const Ints stride = __builtin_convertvector(size, Ints);
        const Ints first = (__builtin_convertvector(firstTexel, Ints) + row * stride + column) * 4;
        const Ints second = first + stride * 4;
        __builtin_memcpy(above, &first, sizeof first);
        __builtin_memcpy(below, &second, sizeof second);
        store(weightX, x - __builtin_convertvector(column, Floats));
        store(weightY, y - __builtin_convertvector(row, Floats));
    }

    /// As `interpolatedMap` of shaders/lib/environment.glsl, at one pixel.
    Four interpolated(const float* texels, int lane) const {
        const float *a = texels + above[lane], *b = texels + below[lane];
        const Four first = loadFour(a) + (loadFour(a + 4) - loadFour(a)) * weightX[lane];
        const Four second = loadFour(b) + (loadFour(b + 4) - loadFour(b)) * weightX[lane];
        return first + (second - first) * weightY[lane];
    }
};

/// Colours of pixels, one after the other.
struct PixelColors {
    float rgba[4 * laneCount];

    void set(int lane, Four color) { __builtin_memcpy(rgba + 4 * lane, &color, sizeof color); }
    Vec3 columns() const {
        Vec3 result;
        for (int lane = 0; lane < laneCount; ++lane) {
            result.x[lane] = rgba[4 * lane];
            result.y[lane] = rgba[4 * lane + 1];
            result.z[lane] = rgba[4 * lane + 2];
        }
        return result;
    }
};

inline Vec3 irradianceAt(const EnvironmentView& environment, Vec3 normal) {
    const MapCells cells(octahedralPoint(normal), splat(environment.irradianceFirst),
                         splat(environment.irradianceSize));
    PixelColors colors;
    for (int lane = 0; lane < laneCount; ++lane)
        colors.set(lane, cells.interpolated(environment.texels, lane));
    Vec3 sum = colors.columns();
    for (int i = 0; i < environment.peakCount; ++i) {
        const float* peak = environment.peaks + 8 * i;
        sum = sum + splat3(peak + 4) * meanCosine(dot(normal, splat3(peak)), splat(peak[3]));
    }
    return sum;
}

inline Vec3 radianceAt(const EnvironmentView& environment, Vec3 direction, Floats level) {
    constexpr int last = EnvironmentView::levelCount - 1;
    const MapPoint point = octahedralPoint(direction);
    const Floats kept = min(max(level, 0.0f), static_cast<float>(last));
    const Ints low = __builtin_convertvector(min(kept, static_cast<float>(last - 1)), Ints);
    const MapCells rough(point, lookUp(environment.firstTexels, low), lookUp(environment.sizes, low));
    const MapCells smooth(point, lookUp(environment.firstTexels + 1, low),
                          lookUp(environment.sizes + 1, low));
    float weights[laneCount];
    store(weights, kept - __builtin_convertvector(low, Floats));
    PixelColors colors;
    for (int lane = 0; lane < laneCount; ++lane) {
        const Four a = rough.interpolated(environment.texels, lane);
        colors.set(lane, a + (smooth.interpolated(environment.texels, lane) - a) * weights[lane]);
    }
    return colors.columns();
}

inline EnvironmentAxes axesOf(const EnvironmentView& environment) {
    return {splat3(environment.axes[0]), splat3(environment.axes[1]), splat3(environment.axes[2])};
}

/// The visibility of `laneCount` pixels of the block, from `first` on.
inline Floats visibilityOf(const TileFrame& frame, int left, int bottom, int first) {
    float visibility[laneCount];
    for (int lane = 0; lane < laneCount; ++lane) {
        const int x = left + (first + lane) % blockSize, y = bottom + (first + lane) / blockSize;
        const bool inside = x < frame.width && y < frame.height;
        const std::int64_t at = static_cast<std::int64_t>(y) * frame.width + x;
        visibility[lane] =
            inside ? static_cast<float>(frame.environmentVisibility[at]) * (1.0f / 255.0f) : 0.0f;
    }
    return load(visibility);
}

/// What `laneCount` pixels of the block, from `first` on, reflect of the environment. A function of its own:
/// the loops over lights keep their registers.
__attribute__((noinline)) void reflectEnvironment(const TileFrame& frame, const ShadingPoint& point, int left,
                                                  int bottom, int first, Vec3& radiance) {
    const EnvironmentView& environment = *frame.environment;
    const EnvironmentAxes axes = axesOf(environment);
    Floats diffuse = splat(environment.intensity), specular = diffuse;
    if (frame.environmentVisibility != nullptr) {
        const Floats visibility = visibilityOf(frame, left, bottom, first);
        diffuse = diffuse * visibility;
        specular = specular * specularVisibility(point, visibility);
    }
    const Vec3 irradiance = irradianceAt(environment, inPicture(axes, point.normal));
    const Vec3 reflected =
        radianceAt(environment, inPicture(axes, specularDirection(point)), environmentLevel(point));
    radiance = environmentRadiance(point, irradiance * diffuse, reflected * specular);
}

inline Vec3 environmentLight(const TileFrame& frame, const ShadingPoint& point, int left, int bottom,
                             int first) {
    Vec3 radiance(0.0f);
    if (frame.environment == nullptr) return radiance;
    const ShadingPoint copy = point;
    reflectEnvironment(frame, copy, left, bottom, first, radiance);
    return radiance;
}

/// Of tile_lobes.h.
template <int brdf>
std::uint32_t shadeLobes(const TileFrame& frame, int left, int bottom, const std::uint32_t* lights,
                         std::uint32_t count);

/// Shades a tile that only the environment lights: no box is needed.
template <int brdf>
void reflectInTile(const TileFrame& frame, int left, int bottom) {
    for (int y = bottom; y < bottom + tileSize && y < frame.height; y += blockSize) {
        for (int x = left; x < left + tileSize && x < frame.width; x += blockSize) {
            const BlockPixels pixels = fetchPixels(frame, x, y);
            std::uint32_t surface = 0;
            for (const std::uint32_t word : pixels.word1) surface |= word;
            if (surface == 0) {
                leaveUnlit(frame, x, y, blockSize);
                continue;
            }
            const std::uint32_t extended =
                frame.lobeWords == nullptr ? 0 : shadeLobes<brdf>(frame, x, y, nullptr, 0);
            for (int first = 0; first < pixelsPerBlock; first += laneCount) {
                if ((extended >> first & 1) != 0) continue;
                const ShadingPoint point = shadingPointAt<brdf>(frame, pixels, first);
                putRadiance(frame, pixels, x, y, first, environmentLight(frame, point, x, y, first));
            }
        }
    }
}

}  // namespace
}  // namespace candela
