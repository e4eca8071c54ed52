#pragma once

// Pixels with more lobes (shaders/shared/extended_lobes.h) in the kernels of `tiles`. Vectors that have such
// a pixel are shaded here, all others as if there were none. Functions are not inlined and fetch
// their own pixels: the loops over lights of plain pixels keep theirs in registers. Included only by
// tile_kernel_code.h.

#include "render/lighting/tiled/tile_environment.h"
#include "render/lighting/tiled/tile_shading.h"
#include "render/lighting/tiled/tile_shadows.h"

namespace candela {
namespace {

// ---- Lobe words

/// The lobe words of a block's pixels: four, and that of diffuse transmission.
struct BlockLobes {
    std::uint32_t vectors = 0;  ///< The bit of its first pixel for each vector that has a pixel with lobes.
    std::uint32_t words[5][pixelsPerBlock];
};

__attribute__((noinline)) void fetchLobes(const TileFrame& frame, int left, int bottom, BlockLobes& lobes) {
    for (int i = 0; i < pixelsPerBlock; ++i) {
        const int x = left + i % blockSize, y = bottom + i / blockSize;
        const bool inside = x < frame.width && y < frame.height;
        const std::int64_t at = static_cast<std::int64_t>(y) * frame.width + x;
        for (int word = 0; word < 4; ++word)
            lobes.words[word][i] = inside ? frame.lobeWords[4 * at + word] : 0;
        lobes.words[4][i] = inside ? frame.diffuseTransmission[at] : 0;
        if (lobes.words[2][i] != 0) lobes.vectors |= 1u << i / laneCount * laneCount;
    }
}

inline Floats channelOf(Ints word, int shift) {
    return __builtin_convertvector((word >> shift) & 0xff, Floats) * (1.0f / 255.0f);
}

inline Vec3 select3(Ints mask, Vec3 a, Vec3 b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

/// As `unpackTangent` of shaders/shared/gbuffer_encoding.h.
inline Vec3 unpackTangent(Vec3 normal, Floats code) {
    const Floats side = select(normal.z < 0.0f, splat(-1.0f), splat(1.0f));
    const Floats a = -1.0f / (side + normal.z), b = normal.x * normal.y * a;
    const Vec3 x{1.0f + side * normal.x * normal.x * a, side * b, -side * normal.x};
    const Vec3 y{b, side + normal.y * normal.y * a, -normal.y};
    const Floats along = code * 2.0f - 1.0f;
    const Vec3 direction = x * along + y * (1.0f - abs(along));
    return direction * inversesqrt(dot(direction, direction));
}

/// As `unpackExtendedLobes` of shaders/shared/gbuffer_encoding.h. Plain pixels of the vector get the lobes
/// that `shadingPoint` gives them.
inline ExtendedLobes unpackExtendedLobes(const TileFrame& frame, const BlockLobes& block, int first,
                                         const SurfaceLobes& surface, Vec3 normal) {
    const auto word = [&](int i) { return loadWords(block.words[i] + first); };
    const Ints extended = word(2) != 0;
    const Vec3 root{channelOf(word(0), 0), channelOf(word(0), 8), channelOf(word(0), 16)};
    ExtendedLobes lobes;
    lobes.f0 = select3(extended, root * root, reflectanceAtNormalIncidence(surface));
    lobes.f90 = select(extended, channelOf(word(0), 24), splat(1.0f));
    lobes.anisotropy = channelOf(word(3), 8);
    lobes.anisotropyDirection = unpackTangent(normal, channelOf(word(3), 16));
    lobes.sheenColor = unpackColor(frame, word(1));
    lobes.sheenRoughness = unpackRoughness((word(1) >> 24) & 0xff);
    lobes.clearcoat = channelOf(word(3), 0);
    lobes.clearcoatRoughness = unpackRoughness((word(2) >> 24) & 0xff);
    lobes.clearcoatNormal = select3(extended, unpackNormal(word(2)), normal);
    lobes.transmission = channelOf(word(3), 24);
    lobes.diffuseTransmission = channelOf(word(4), 24);
    lobes.diffuseTransmissionColor = unpackColor(frame, word(4));
    return lobes;
}

template <int brdf>
__attribute__((noinline)) void extendedPointAt(const TileFrame& frame, const BlockPixels& pixels,
                                               const BlockLobes& block, int first, ExtendedPoint& point) {
    const Ints word0 = loadWords(pixels.word0 + first), word1 = loadWords(pixels.word1 + first);
    const Vec3 position = positionOf(frame, pixels, first), normal = unpackNormal(word1);
    const SurfaceLobes surface = unpackLobes(frame, word0, word1);
    const ExtendedLobes lobes = unpackExtendedLobes(frame, block, first, surface, normal);
    point =
        extendedPoint(brdf, surface, lobes, normal, position, wayToEye(frame, position),
                      {frame.albedoTable, frame.albedoTableSize}, {frame.sheenTable, frame.albedoTableSize});
}

// ---- Shading

/// Adds what reflects of `received` from direction l.
template <int brdf>
__attribute__((noinline)) void addReflection(const ExtendedPoint& point, const Vec3& l, const Vec3& received,
                                             Vec3& sum) {
    sum = sum + extendedReflection(brdf, point, l) * received;
}

/// Adds what `laneCount` pixels of the block, from `first` on, reflect of the environment.
__attribute__((noinline)) void addEnvironment(const TileFrame& frame, const ExtendedPoint& point, int left,
                                              int bottom, int first, Vec3& sum) {
    const EnvironmentView& environment = *frame.environment;
    const EnvironmentAxes axes = axesOf(environment);
    const bool hidden = frame.environmentVisibility != nullptr;
    const Floats visibility = hidden ? visibilityOf(frame, left, bottom, first) : splat(1.0f);
    const auto gathered = [&](const ShadingPoint& lobe) {
        const Vec3 light =
            radianceAt(environment, inPicture(axes, specularDirection(lobe)), environmentLevel(lobe));
        return hidden ? light * specularVisibility(lobe, visibility) : light;
    };
    const Vec3 normal = point.base.normal;
    GatheredLight light;
    light.irradiance = irradianceAt(environment, inPicture(axes, normal)) * visibility;
    light.irradianceBehind = irradianceAt(environment, inPicture(axes, Vec3(0.0f) - normal)) * visibility;
    light.base = gathered(baseInEnvironment(point));
    light.coat = gathered(point.coat);
    light.sheen = gathered(sheenInEnvironment(point));
    sum = sum + extendedEnvironmentRadiance(point, light) * splat(environment.intensity);
}

/// How a light reaches `laneCount` pixels.
struct Arrival {
    Vec3 l;
    Vec3 received;  ///< Without the cosine.
};

inline Arrival arrivalOf(const TileFrame& frame, const ShadingPoint& point, std::uint64_t light) {
    const float* record = frame.records + 8 * light;
    if (light >= frame.localCount) return {splat3(record), splat3(record + 4)};
    const LocalLight local = localLightOf(record);
    const LightPath path = pathToLight(point, local);
    if (light < frame.pointCount) return {path.l, local.intensity * path.attenuation};
    const Floats ramp = coneRamp(lightConeOf(frame.cones + 4 * (light - frame.pointCount)), path.l);
    return {path.l, local.intensity * (path.attenuation * ramp * ramp)};
}

/// What of `received` from light `index` of the block gets to its pixels from `first` on.
inline Vec3 unhidden(const ShadowScratch& shadows, std::uint32_t index, int first, Vec3 received) {
    if (shadows.dimmed[index] != 0)
        return received * load(shadows.transmittance + std::uint64_t{index} * raysPerBlock + first);
    return masked(received, lanesOf(shadows.visible[index], first));
}

/// Shades the vectors of a block that have pixels with lobes, by the lights of `lights` and, but for what
/// `shadows` hides, where that is not null and `lights` are slots.
template <int brdf>
__attribute__((noinline)) void shadeExtended(const TileFrame& frame, const BlockLobes& lobes, int left,
                                             int bottom, const std::uint32_t* lights, std::uint32_t count,
                                             const ShadowScratch* shadows) {
    constexpr std::uint32_t lanes = (1u << (laneCount - 1) << 1) - 1;
    const BlockPixels pixels = fetchPixels(frame, left, bottom);
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        if ((lobes.vectors >> first & 1) == 0) continue;
        ExtendedPoint point;
        extendedPointAt<brdf>(frame, pixels, lobes, first, point);
        Vec3 sum(0.0f);
        if (frame.environment != nullptr) addEnvironment(frame, point, left, bottom, first, sum);
        for (std::uint32_t i = 0; i < count + frame.directionalCount; ++i) {
            if (shadows != nullptr && (shadows->visible[i] >> first & lanes) == 0) continue;
            std::uint64_t light = std::uint64_t{frame.localCount} + i - count;
            if (i < count) light = shadows != nullptr ? shadows->lightOfSlot[lights[i]] : lights[i];
            Arrival arrival = arrivalOf(frame, point.base, light);
            if (shadows != nullptr) arrival.received = unhidden(*shadows, i, first, arrival.received);
            addReflection<brdf>(point, arrival.l, arrival.received, sum);
        }
        putRadiance(frame, pixels, left, bottom, first, sum);
    }
}

/// The vectors that `shadeExtended` shades, as `BlockLobes::vectors`, after it has. The frame has lobe words.
template <int brdf>
__attribute__((noinline)) std::uint32_t shadeLobes(const TileFrame& frame, int left, int bottom,
                                                   const std::uint32_t* lights, std::uint32_t count) {
    BlockLobes lobes;
    fetchLobes(frame, left, bottom, lobes);
    if (lobes.vectors != 0) shadeExtended<brdf>(frame, lobes, left, bottom, lights, count, nullptr);
    return lobes.vectors;
}

}  // namespace
}  // namespace candela
