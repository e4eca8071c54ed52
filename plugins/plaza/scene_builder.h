#pragma once

#include <candela/plugin.h>

#include <array>
#include <cstdint>
#include <string>

#include "../common/host.h"
#include "geometry.h"

namespace candela_plugins::plaza {

/// Mixes all bits of a number: the finaliser of MurmurHash3 (Austin Appleby, public domain).
constexpr std::uint32_t mixBits(std::uint32_t bits) {
    bits ^= bits >> 16;
    bits *= 0x85EBCA6Bu;
    bits ^= bits >> 13;
    bits *= 0xC2B2AE35u;
    bits ^= bits >> 16;
    return bits;
}

/// A pseudo-random number of [0, 1) for a property of the element `index`. It is a multiple of 2^-24, so that
/// float holds it exactly, and the same on every machine.
constexpr double hashedFraction(std::uint32_t index, std::uint32_t property) {
    const std::uint32_t bits = mixBits(mixBits(index + 1u) + 0x9E3779B9u * (property + 1u));
    return static_cast<double>(bits >> 8) / 16777216.0;
}

/// Both ends included.
struct CountRange {
    std::uint32_t min = 0, max = 16'000'000;
};

/// Reads a whole number of the range written in digits alone. Throws `Failure` that names `element` and shows
/// `example` when `text` is anything else.
std::uint32_t parseCount(const std::string& text, const std::string& element, const std::string& example,
                         const CountRange& range = {});

/// Linear interpolation: `low` at fraction 0, `high` at fraction 1.
double between(double low, double high, double fraction);

/// The fully saturated colour of a hue of [0, 1): one channel is 1, one is 0.
std::array<float, 3> hueColor(double hue);

/// Black, not metallic, of roughness 0, without textures. `name` must live as long as the material.
candela_material plainMaterial(const std::string& name);

/// Adds a grey material, linear. Returns its index.
int32_t addGreyMaterial(const Host& host, const std::string& name, float grey, float roughness);

/// Adds a mesh of one material. Returns its index.
int32_t addMesh(const Host& host, const Geometry& geometry, int32_t material, const std::string& name);

/// A root at the origin; `mesh` is -1 for none. `name` must live as long as the node.
candela_node plainNode(const std::string& name, int32_t mesh);

/// Adds a mesh of one material, and a node at the origin.
void addGeometry(const Host& host, const Geometry& geometry, int32_t material, const std::string& name);

/// Adds `node`, and a camera of 45 degrees at it with the same name.
void addCamera(const Host& host, const candela_node& node);
/// The same at (0, height, distance), looking at the origin.
void addCameraAt(const Host& host, double height, double distance);

/// A black point light at the origin, without a node. `candela` and `range` in candela and metres.
candela_light plainLight(float candela, float range);

/// Adds the lights 0 to `count` - 1 that `lightAt` makes, and reports progress.
template <typename LightAt>
void addLights(const Host& host, std::uint32_t count, LightAt&& lightAt) {
    constexpr std::uint32_t lightsBetweenProgress = 4096;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i % lightsBetweenProgress == 0) host.progress(static_cast<double>(i) / count);
        const candela_light light = lightAt(i);
        host.add(light);
    }
    host.progress(1.0);
}

}  // namespace candela_plugins::plaza
