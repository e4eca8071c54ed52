#pragma once

// Shadows in the kernels of `tiles`. For a box of 16 × 16 pixels and each of its lights, the instances are
// listed that may hide the light from the box. For a block of pixels and a light their triangles are tested:
// first against all rays of the block at once, and those that remain against each ray. Where these are many,
// or mask or blend by alpha, the rays are traced. Included only by tile_kernel_code.h.

#include "render/lighting/tiled/tile_kernel.h"
#include "render/lighting/tiled/tile_shading.h"
#include "render/occlusion/block_occlusion_code.h"

namespace candela {
namespace {

static_assert(raysPerBlock == pixelsPerBlock);

constexpr float infinity = 1.0e30f;  // farther than any surface

// ---- Ray ends

inline Floats halfToFloat(Ints half) {
    // The exponent's bias differs by 112; the product makes denormal halves right, too.
    const Ints bits = (half & 0x7fff) << 13;
    Floats value;
    __builtin_memcpy(&value, &bits, sizeof value);
    return value * 5.192296858534828e33f;  // 2^112
}

/// The inverse of `packShadowWord` of shaders/shared/gbuffer_encoding.h.
inline Vec3 unpackGeometricNormal(Ints word) {
    const Floats x = (__builtin_convertvector((word >> 16) & 0xff, Floats) - 128.0f) * (1.0f / 127.0f);
    const Floats y = (__builtin_convertvector((word >> 24) & 0xff, Floats) - 128.0f) * (1.0f / 127.0f);
    const Floats z = 1.0f - abs(x) - abs(y);
    const Ints lower = z < 0.0f;
    const Vec3 n{select(lower, octahedralFold(y, x), x), select(lower, octahedralFold(x, y), y), z};
    return n * inversesqrt(dot(n, n));
}

/// The side of a pixel at a surface, metres.
inline Floats pixelExtent(const TileFrame& frame, Vec3 position) {
    if (frame.orthographic) return splat(frame.pixelSide);
    return dot(position - splat3(frame.eye), splat3(frame.forward)) * frame.pixelSide;
}

inline void fetchShadowWords(const TileFrame& frame, int left, int bottom, std::uint32_t* words) {
    for (int i = 0; i < pixelsPerBlock; ++i) {
        const int x = left + i % blockSize, y = bottom + i / blockSize;
        const bool inside = x < frame.width && y < frame.height;
        words[i] = inside ? frame.shadowWords[static_cast<std::int64_t>(y) * frame.width + x] : 0;
    }
}

/// On which side of a surface rays end.
enum class RaySide {
    inFront,
    behind,  ///< Of lights whose light passes through it.
};

/// The ends of the block's rays. Undefined where there is no surface.
template <RaySide side = RaySide::inFront>
inline BlockVectors rayEnds(const TileFrame& frame, const BlockPixels& pixels, int left, int bottom) {
    std::uint32_t words[pixelsPerBlock];
    fetchShadowWords(frame, left, bottom, words);
    BlockVectors ends;
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        const Ints word = loadWords(words + first);
        const Vec3 position = positionOf(frame, pixels, first);
        const Vec3 end = side == RaySide::inFront
                             ? shadowRayEnd(position, wayToEye(frame, position), unpackGeometricNormal(word),
                                            halfToFloat(word), pixelExtent(frame, position))
                             : shadowRayEndBehind(position, wayToEye(frame, position),
                                                  unpackGeometricNormal(word), pixelExtent(frame, position));
        store(ends.x + first, end.x), store(ends.y + first, end.y), store(ends.z + first, end.z);
    }
    return ends;
}

/// A bit for each pixel with a surface.
inline std::uint32_t surfaceBits(const BlockPixels& pixels) {
    std::uint32_t bits = 0;
    for (int first = 0; first < pixelsPerBlock; first += laneCount)
        bits |= laneBits(isSurface(pixels, first)) << first;
    return bits;
}

inline void enclose(EndBox& box, const BlockPixels& pixels, const BlockVectors& ends) {
    const Floats high = splat(infinity);
    for (int first = 0; first < pixelsPerBlock; first += laneCount) {
        const Ints surface = isSurface(pixels, first);
        const Vec3 end = ends.lanes(first);
        const Floats axes[] = {end.x, end.y, end.z};
        for (int axis = 0; axis < 3; ++axis) {
            const float low = minOfLanes(select(surface, axes[axis], high));
            const float top = -minOfLanes(select(surface, -axes[axis], high));
            box.min[axis] = low < box.min[axis] ? low : box.min[axis];
            box.max[axis] = top > box.max[axis] ? top : box.max[axis];
        }
    }
}

inline EndBox emptyEndBox() {
    return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

/// Grows the box by more than the tests against it round, and less than ray ends are off the surface.
inline void addRounding(EndBox& box) {
    float largest = 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        largest = max(largest, max(-box.min[axis], box.min[axis]));
        largest = max(largest, max(-box.max[axis], box.max[axis]));
    }
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] -= 0.25f * SHADOW_MARGIN_ROUNDING * largest;
        box.max[axis] += 0.25f * SHADOW_MARGIN_ROUNDING * largest;
    }
}

/// Around the ray ends of the pixels of a node of the box tree.
inline EndBox endBoxOf(const TileFrame& frame, int left, int bottom, int blocks) {
    EndBox box = emptyEndBox();
    for (int y = 0; y < blocks; ++y) {
        for (int x = 0; x < blocks; ++x) {
            const BlockPixels pixels = fetchPixels(frame, left + x * blockSize, bottom + y * blockSize);
            enclose(box, pixels, rayEnds(frame, pixels, left + x * blockSize, bottom + y * blockSize));
            if (frame.lobeWords == nullptr) continue;
            enclose(box, pixels,
                    rayEnds<RaySide::behind>(frame, pixels, left + x * blockSize, bottom + y * blockSize));
        }
    }
    addRounding(box);
    return box;
}

// ---- Lights and what may hide them

inline LightSource pointSource(const float* record) {
    return {{record[0], record[1], record[2]}, true};
}

inline LightSource directionalSource(const float* record) {
    return {{record[0], record[1], record[2]}, false};
}

inline bool castsShadow(const float* record) {
    return record[7] != 0.0f;
}

/// Fills the slots of a box: the lights of `list`, whose indices become slots.
inline void fillSlots(const TileFrame& frame, const EndBox& box, const LightColumns& list,
                      std::uint32_t count, ShadowScratch& scratch) {
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        const std::uint32_t light = list.index[slot];
        const float* record = frame.records + 8 * std::uint64_t{light};
        scratch.lightOfSlot[slot] = light;
        if (castsShadow(record))
            listInstances(*frame.occlusion, pointSource(record), box, scratch.locals[slot]);
        list.index[slot] = slot;
    }
    for (std::uint32_t i = 0; i < frame.directionalCount; ++i) {
        const float* record = frame.records + 8 * (std::uint64_t{frame.localCount} + i);
        if (castsShadow(record))
            listInstances(*frame.occlusion, directionalSource(record), box, scratch.directionals[i]);
    }
}

// ---- Rays of a block

/// The ray ends of a block, and their box in the spaces of the instances asked for last.
struct ShadowBlock {
    BlockVectors ends;  ///< World.
    EndBox box;
    static constexpr std::uint32_t cached = 8;
    std::uint32_t instances[cached];  ///< By the last bits of their number; all ones: none yet.
    EndBox localBoxes[cached];

    const EndBox& localBox(const OcclusionView& scene, std::uint32_t instance) {
        const std::uint32_t place = instance % cached;
        if (instances[place] != instance) {
            instances[place] = instance;
            localBoxes[place] = transformed(box, scene.instances[instance].localFromWorld);
        }
        return localBoxes[place];
    }
};

template <RaySide side = RaySide::inFront>
inline ShadowBlock shadowBlockOf(const TileFrame& frame, const BlockPixels& pixels, int left, int bottom) {
    ShadowBlock block;
    block.ends = rayEnds<side>(frame, pixels, left, bottom);
    block.box = emptyEndBox();
    enclose(block.box, pixels, block.ends);
    addRounding(block.box);
    for (std::uint32_t& instance : block.instances) instance = 0xffffffffu;
    return block;
}

inline StartedRays raysTo(const LightSource& light, const ShadowBlock& block) {
    StartedRays result;
    BlockRays& rays = result.rays;
    rays.light = light;
    for (int axis = 0; axis < 3; ++axis)
        rays.origin[axis] =
            light.isPoint ? light.place[axis] : 0.5f * (block.box.min[axis] + block.box.max[axis]);
    for (int first = 0; first < raysPerBlock; first += laneCount) {
        const Vec3 end = block.ends.lanes(first) - splat3(rays.origin);
        store(rays.ends.x + first, end.x), store(rays.ends.y + first, end.y),
            store(rays.ends.z + first, end.z);
        store(result.start + first, shadowRayStart(splat3(light.place), end));
    }
    return result;
}

/// Traces the rays of `traced` (a bit each) one by one. See `TracePacket`.
inline std::uint32_t traceRays(const TileFrame& frame, const StartedRays& rays, const ShadowBlock& block,
                               std::uint32_t traced, float* transmittance) {
    RayPacket packet;
    const float* ends[] = {block.ends.x, block.ends.y, block.ends.z};
    const LightSource& light = rays.rays.light;
    for (int i = 0; i < raysPerBlock; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            packet.origin[axis][i] = light.isPoint ? light.place[axis] : ends[axis][i];
            packet.direction[axis][i] = light.isPoint ? ends[axis][i] - light.place[axis] : light.place[axis];
        }
        packet.tMin[i] = light.isPoint ? rays.start[i] : 0.0f;
        packet.tMax[i] = light.isPoint ? 1.0f : infinity;
        packet.active[i] = (traced >> i & 1) != 0 ? -1 : 0;
    }
    return frame.occlusion->trace(frame.occlusion->rays, packet, transmittance);
}

/// What a light's shadow does to the pixels of a block, a bit each.
struct BlockShadow {
    std::uint32_t hidden = 0;
    std::uint32_t dimmed = 0;  ///< A part of the light reaches them.
};

/// The share of the light that reaches each pixel, into `kept`, where it is a part at any. `traced` is what
/// the rays of those that are not `hidden` have found.
inline std::uint32_t keepTransmittance(const float* traced, std::uint32_t hidden, float* kept) {
    std::uint32_t dimmed = 0;
    for (int i = 0; i < raysPerBlock; ++i) dimmed |= (traced[i] > 0.0f && traced[i] < 1.0f ? 1u : 0u) << i;
    if (dimmed == 0) return 0;
    for (int i = 0; i < raysPerBlock; ++i) kept[i] = (hidden >> i & 1) != 0 ? 0.0f : traced[i];
    return dimmed;
}

/// The shadow of light `index` of the block on the pixels of `lit` (a bit each), cast by the instances of
/// `list`.
inline BlockShadow shadowOn(const TileFrame& frame, const LightSource& light, const InstanceList& list,
                            ShadowBlock& block, std::uint32_t lit, std::uint32_t index,
                            ShadowScratch& scratch) {
    if (list.count == 0) return {};
    const OcclusionView& scene = *frame.occlusion;
    const Hull hull = hullOf(light, block.box);
    StartedRays rays;
    bool hasRays = false;
    const auto worldRays = [&]() -> const StartedRays& {
        if (!hasRays) rays = raysTo(light, block);
        hasRays = true;
        return rays;
    };
    BlockHits hits{lit};
    ClippedRays clipped;
    bool hasClipped = false;
    const auto test = [&](std::uint32_t instance, ChildBox box) {
        if (!hasClipped) clipped = clippedRays(worldRays().rays);
        hasClipped = true;
        if ((raysInto(clipped, box) & lit & ~hits.hidden) == 0) return true;
        return testInstance(scene.instances[instance], light, block.localBox(scene, instance), worldRays,
                            hits);
    };
    if (list.count == InstanceList::overflow) {
        const bool whole = visitLeaves(scene.nodes, hull, test);
        if (!whole && (lit & ~hits.hidden) != 0) hits.undecided = true;
    } else {
        for (std::uint32_t met = instancesMet(list, hull); met != 0; met &= met - 1) {
            const int lane = __builtin_ctz(met);
            if (!test(list.node.child[lane], {&list.node, lane})) break;
        }
    }
    hits.hidden &= lit;
    if (hits.tested || hits.undecided)
        scratch.raysTraced += static_cast<std::uint64_t>(__builtin_popcount(lit));
    BlockShadow shadow{hits.hidden};
    if (hits.undecided && hits.hidden != lit) {
        float transmittance[raysPerBlock];
        shadow.hidden |= traceRays(frame, worldRays(), block, lit & ~hits.hidden, transmittance);
        if (scene.blends) {
            shadow.dimmed = keepTransmittance(transmittance, shadow.hidden,
                                              scratch.transmittance + std::uint64_t{index} * raysPerBlock);
        }
    }
    return shadow;
}

// ---- Which pixels a light would light

inline std::uint32_t litByPoint(const ShadingPoint& point, const LocalLight& light) {
    const Vec3 d = light.position - point.position;
    return laneBits((dot(d, d) * light.inverseRange2 < 1.0f) & (dot(point.normal, d) > 0.0f));
}

inline std::uint32_t litBySpot(const ShadingPoint& point, const LocalLight& light, const LightCone& cone) {
    const Vec3 d = light.position - point.position;
    const Vec3 l = d * inversesqrt(max(dot(d, d), 1.0e-24f));
    return litByPoint(point, light) & laneBits(cone.offset - dot(l, cone.axis) > 0.0f);
}

inline std::uint32_t litByDirectional(const ShadingPoint& point, Vec3 l) {
    return laneBits(dot(point.normal, l) > 0.0f);
}

/// All bits of a lane where its bit is set.
inline Ints lanesOf(std::uint32_t bits, int first) {
    Ints mask;
    for (int lane = 0; lane < laneCount; ++lane)
        mask[lane] = static_cast<std::int32_t>(bits >> (first + lane) & 1);
    return mask != 0;
}

inline Vec3 masked(Vec3 value, Ints mask) {
    return {select(mask, value.x, Floats{}), select(mask, value.y, Floats{}),
            select(mask, value.z, Floats{})};
}

}  // namespace
}  // namespace candela
