#pragma once

// Which pixels of a block each light reaches, in frames with shadows. Included only by tile_kernel_code.h.

#include "render/lighting/tiled/tile_kernel.h"
#include "render/lighting/tiled/tile_lobes.h"
#include "render/lighting/tiled/tile_shading.h"
#include "render/lighting/tiled/tile_shadows.h"

namespace candela {
namespace {

// ---- Pixels with more lobes

/// The sides from which pixels of a block with lobes are lit.
struct LobeSides {
    BlockLobes lobes;
    Vec3 position[pixelsPerBlock / laneCount], normal[pixelsPerBlock / laneCount];
    Floats clearcoat[pixelsPerBlock / laneCount], passing[pixelsPerBlock / laneCount];
    Vec3 clearcoatNormal[pixelsPerBlock / laneCount], geometricNormal[pixelsPerBlock / laneCount];
    ShadowBlock behind;  ///< The ends of rays of lights behind the surfaces.
};

__attribute__((noinline)) void fillSides(const TileFrame& frame, int left, int bottom, LobeSides& sides) {
    fetchLobes(frame, left, bottom, sides.lobes);
    if (sides.lobes.vectors == 0) return;
    const BlockPixels pixels = fetchPixels(frame, left, bottom);
    std::uint32_t shadowWords[pixelsPerBlock];
    fetchShadowWords(frame, left, bottom, shadowWords);
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        const int vector = first / laneCount;
        sides.position[vector] = positionOf(frame, pixels, first);
        sides.normal[vector] = unpackNormal(loadWords(pixels.word1 + first));
        const Ints strengths = loadWords(sides.lobes.words[3] + first);
        sides.clearcoat[vector] = channelOf(strengths, 0);
        sides.passing[vector] = channelOf(loadWords(sides.lobes.words[4] + first), 24);
        sides.clearcoatNormal[vector] = unpackNormal(loadWords(sides.lobes.words[2] + first));
        sides.geometricNormal[vector] = unpackGeometricNormal(loadWords(shadowWords + first));
    }
    sides.behind = shadowBlockOf<RaySide::behind>(frame, pixels, left, bottom);
}

/// The pixels that a light reaches if nothing hides it, and those of them that it reaches from behind.
struct Reached {
    std::uint32_t lit = 0, behind = 0;
};

/// Of the vectors with lobes. `cone` is null for a light that is no spot.
__attribute__((noinline)) Reached reachedByLobes(const LobeSides& sides, bool isPoint, const float* record,
                                                 const float* cone) {
    Reached reached;
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        if ((sides.lobes.vectors >> first & 1) == 0) continue;
        const int vector = first / laneCount;
        const Vec3 normal = sides.normal[vector];
        const Vec3 d = isPoint ? splat3(record) - sides.position[vector] : splat3(record);
        Ints inside = ~Ints{};
        if (isPoint) inside = dot(d, d) * record[3] < 1.0f;
        if (cone != nullptr) {
            const Vec3 l = d * inversesqrt(max(dot(d, d), 1.0e-24f));
            inside = inside & (cone[3] - dot(l, splat3(cone)) > 0.0f);
        }
        const Floats passing = sides.passing[vector];
        const Floats facing =
            facingOfLobes(normal, sides.clearcoat[vector], sides.clearcoatNormal[vector], passing, d);
        const Ints behind =
            (passing > 0.0f) & (dot(normal, d) < 0.0f) & (dot(sides.geometricNormal[vector], d) < 0.0f);
        reached.lit |= laneBits(inside & (facing > 0.0f)) << first;
        reached.behind |= laneBits(inside & behind) << first;
    }
    return reached;
}

/// As `shadowOn`, where `behind` of the pixels `lit` are lit from behind.
__attribute__((noinline)) BlockShadow shadowOnBothSides(const TileFrame& frame, const LightSource& light,
                                                        const InstanceList& list, ShadowBlock& inFront,
                                                        ShadowBlock& behindBlock, std::uint32_t lit,
                                                        std::uint32_t behind, std::uint32_t index,
                                                        ShadowScratch& scratch) {
    const BlockShadow a = shadowOn(frame, light, list, inFront, lit & ~behind, index, scratch);
    float kept[raysPerBlock];
    float* shared = scratch.transmittance + std::uint64_t{index} * raysPerBlock;
    if (a.dimmed != 0) __builtin_memcpy(kept, shared, sizeof kept);
    const BlockShadow b = shadowOn(frame, light, list, behindBlock, behind, index, scratch);
    const BlockShadow both{(a.hidden & ~behind) | (b.hidden & behind),
                           (a.dimmed & ~behind) | (b.dimmed & behind)};
    if (both.dimmed == 0) return both;
    for (int i = 0; i < raysPerBlock; ++i) {
        const bool isBehind = (behind >> i & 1) != 0;
        const float passing =
            isBehind ? (b.dimmed != 0 ? shared[i] : 1.0f) : (a.dimmed != 0 ? kept[i] : 1.0f);
        shared[i] = (both.hidden >> i & 1) != 0 ? 0.0f : passing;
    }
    return both;
}

// ---- A block

/// Finds which pixels of the block each light of the slots reaches, with `visible`, `hidden`, `dimmed` and
/// `transmittance` of the scratch. `sides` is null in a block without further lobes.
template <int brdf>
void findVisible(const TileFrame& frame, const BlockPixels& pixels, ShadowBlock& block,
                 const std::uint32_t* slots, std::uint32_t count, ShadowScratch& scratch, LobeSides* sides) {
    const std::uint32_t surface = surfaceBits(pixels);
    ShadingPoint points[pixelsPerBlock / laneCount];
    for (int group = 0; group < pixelsPerBlock / laneCount; ++group)
        points[group] = shadingPointAt<brdf>(frame, pixels, group * laneCount);
    const auto litBits = [&](const auto& litBy) {
        std::uint32_t bits = 0;
        for (int group = 0; group < pixelsPerBlock / laneCount; ++group)
            bits |= litBy(points[group]) << group * laneCount;
        return bits & surface;
    };
    const auto finish = [&](std::uint32_t i, const float* record, const float* cone, const LightSource& light,
                            const InstanceList& instances, std::uint32_t lit) {
        BlockShadow shadow;
        std::uint32_t behind = 0;
        if (sides != nullptr) {
            const Reached reached = reachedByLobes(*sides, light.isPoint, record, cone);
            lit |= reached.lit & surface;
            behind = reached.behind & surface;
        }
        if (castsShadow(record) && lit != 0) {
            scratch.raysAsked += static_cast<std::uint64_t>(__builtin_popcount(lit));
            shadow = behind == 0 ? shadowOn(frame, light, instances, block, lit, i, scratch)
                                 : shadowOnBothSides(frame, light, instances, block, sides->behind, lit,
                                                     behind, i, scratch);
        }
        scratch.visible[i] = static_cast<std::uint16_t>(lit & ~shadow.hidden);
        scratch.hidden[i] = static_cast<std::uint16_t>(shadow.hidden);
        scratch.dimmed[i] = static_cast<std::uint16_t>(shadow.dimmed);
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t light = scratch.lightOfSlot[slots[i]];
        const float* record = frame.records + 8 * std::uint64_t{light};
        const LocalLight local = localLightOf(record);
        const float* cone =
            light < frame.pointCount ? nullptr : frame.cones + 4 * std::uint64_t{light - frame.pointCount};
        const std::uint32_t lit =
            cone == nullptr ? litBits([&](const ShadingPoint& point) { return litByPoint(point, local); })
                            : litBits([&](const ShadingPoint& point) {
                                  return litBySpot(point, local, lightConeOf(cone));
                              });
        finish(i, record, cone, pointSource(record), scratch.locals[slots[i]], lit);
    }
    for (std::uint32_t i = 0; i < frame.directionalCount; ++i) {
        const float* record = frame.records + 8 * (std::uint64_t{frame.localCount} + i);
        const std::uint32_t lit =
            litBits([&](const ShadingPoint& point) { return litByDirectional(point, splat3(record)); });
        finish(count + i, record, nullptr, directionalSource(record), scratch.directionals[i], lit);
    }
}

/// `findVisible` of a block whose pixels are `pixels`. `sides` is filled where it returns it, else null.
template <int brdf>
const LobeSides* findVisibleOf(const TileFrame& frame, const BlockPixels& pixels, int left, int bottom,
                               const std::uint32_t* slots, std::uint32_t count, ShadowScratch& scratch,
                               LobeSides& sides) {
    ShadowBlock block = shadowBlockOf(frame, pixels, left, bottom);
    if (frame.lobeWords != nullptr) fillSides(frame, left, bottom, sides);
    LobeSides* used = sides.lobes.vectors != 0 ? &sides : nullptr;
    findVisible<brdf>(frame, pixels, block, slots, count, scratch, used);
    return used;
}

}  // namespace
}  // namespace candela
