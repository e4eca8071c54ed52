#pragma once

// The light of the environment (shaders/shared/environment.h) over vectors of pixels. Included only by
// tile_kernel_code.h.

#include "render/lighting/tiled/tile_shading.h"

namespace candela {
namespace {

inline Four fourAt(const float* from) {
    Four v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}

/// As `interpolatedMap` of shaders/lib/environment.glsl, at one pixel.
inline Four interpolatedMap(const EnvironmentView::Map& map, float u, float v) {
    const float x = u * static_cast<float>(map.size) + 0.5f, y = v * static_cast<float>(map.size) + 0.5f;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const float weightX = x - static_cast<float>(column), weightY = y - static_cast<float>(row);
    const std::int64_t stride = 4 * (static_cast<std::int64_t>(map.size) + 2);
    const float* at = map.texels + row * stride + std::int64_t{4} * column;
    const Four above = fourAt(at) + (fourAt(at + 4) - fourAt(at)) * weightX;
    const float* next = at + stride;
    const Four below = fourAt(next) + (fourAt(next + 4) - fourAt(next)) * weightX;
    return above + (below - above) * weightY;
}

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

/// Points of a map for each pixel. Numbers that are none become 0.
struct PixelPoints {
    float u[laneCount], v[laneCount];

    explicit PixelPoints(MapPoint point) {
        store(u, min(max(point.u, 0.0f), 1.0f));
        store(v, min(max(point.v, 0.0f), 1.0f));
    }
};

inline Vec3 irradianceAt(const EnvironmentView& environment, Vec3 normal) {
    const PixelPoints points(octahedralPoint(normal));
    PixelColors colors;
    for (int lane = 0; lane < laneCount; ++lane)
        colors.set(lane, interpolatedMap(environment.irradiance, points.u[lane], points.v[lane]));
    Vec3 sum = colors.columns();
    for (int i = 0; i < environment.peakCount; ++i) {
        const float* peak = environment.peaks + 8 * i;
        sum = sum + splat3(peak + 4) * max(dot(normal, splat3(peak)), 0.0f);
    }
    return sum;
}

inline Vec3 radianceAt(const EnvironmentView& environment, Vec3 direction, Floats level) {
    constexpr int last = EnvironmentView::levelCount - 1;
    const PixelPoints points(octahedralPoint(direction));
    float levels[laneCount];
    store(levels, min(max(level, 0.0f), static_cast<float>(last)));
    PixelColors colors;
    for (int lane = 0; lane < laneCount; ++lane) {
        const int low =
            levels[lane] < static_cast<float>(last - 1) ? static_cast<int>(levels[lane]) : last - 1;
        const Four a = interpolatedMap(environment.levels[low], points.u[lane], points.v[lane]);
        const Four b = interpolatedMap(environment.levels[low + 1], points.u[lane], points.v[lane]);
        colors.set(lane, a + (b - a) * (levels[lane] - static_cast<float>(low)));
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

}  // namespace
}  // namespace candela
