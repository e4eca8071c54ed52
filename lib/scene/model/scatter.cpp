#include <candela/error.h>
#include <candela/scene.h>

#include "base/error_context.h"
#include "scene/validate/scene_rules.h"

#include <cmath>
#include <new>
#include <stdexcept>

// The same lights on every machine: integer arithmetic, and float operations that IEEE 754 rounds exactly,
// one by one (this file is compiled without contraction to fused multiply-add).

namespace candela {

namespace {

// A bijection of 32 bits with little bias. Constants: Chris Wellons, "Prospecting for hash functions", 2018
// (lowbias32).
std::uint32_t mix(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

// A number of [0, 1) with 24 bits, which a float holds exactly.
float unitFloat(std::uint32_t key, std::uint32_t dimension) {
    return static_cast<float>(mix(key + dimension * 0x9e3779b9u) >> 8) * 0x1p-24f;
}

// Red at 0, green at 1/3, blue at 2/3; the strongest channel is 1 and the weakest 0.
glm::vec3 saturatedColor(float hue) {
    const float sector = hue * 6.0f;
    const auto whole = static_cast<int>(sector);
    const float rise = sector - static_cast<float>(whole);
    const float fall = 1.0f - rise;
    switch (whole) {
        case 0:
            return {1.0f, rise, 0.0f};
        case 1:
            return {fall, 1.0f, 0.0f};
        case 2:
            return {0.0f, 1.0f, rise};
        case 3:
            return {0.0f, fall, 1.0f};
        case 4:
            return {rise, 0.0f, 1.0f};
        default:
            return {1.0f, 0.0f, fall};
    }
}

// Interpolates by weights: the result stays within the limits, and their difference can not overflow.
float between(float low, float high, float u) {
    const float value = low * (1.0f - u) + high * u;
    return value < low ? low : value > high ? high : value;
}

void require(bool holds, const char* rule) {
    if (!holds) throw Error(ErrorKind::badInput, {}, rule);
}

void reserve(std::vector<Light>& lights, std::uint32_t count) {
    const std::string reason = "there is no memory for " + std::to_string(count) + " more lights";
    try {
        lights.reserve(lights.size() + count);
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::limit, {}, reason);
    } catch (const std::length_error&) {
        throw Error(ErrorKind::limit, {}, reason);
    }
}

}  // namespace

void scatterLights(std::vector<Light>& lights, const Bounds& bounds, std::uint32_t count, float range,
                   float candela, std::uint32_t seed) {
    require(!bounds.empty() && allFinite(bounds.min) && allFinite(bounds.max),
            "lights need a box to be scattered over, and the scene has no geometry");
    require(range > 0.0f && std::isfinite(range), "the range of scattered lights must be over 0 metres");
    require(candela >= 0.0f && candela <= maxIntensity,
            "the intensity of scattered lights must lie between 0 and 1e20 candela");
    reserve(lights, count);
    const std::uint32_t seedKey = mix(seed);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t key = mix(seedKey ^ mix(i));
        Light& light = lights.emplace_back();
        light.position = {between(bounds.min.x, bounds.max.x, unitFloat(key, 1)),
                          between(bounds.min.y, bounds.max.y, unitFloat(key, 2)),
                          between(bounds.min.z, bounds.max.z, unitFloat(key, 3))};
        light.color = saturatedColor(unitFloat(key, 4));
        light.range = range;
        light.intensity = candela;
    }
}

}  // namespace candela
