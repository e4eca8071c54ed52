#pragma once

#include "generator.h"
#include "shapes.h"

#include <candela/plugin.h>

#include <array>
#include <cstdint>
#include <string>

namespace plaza {

/// `low` at share 0, `high` at share 1.
double between(double low, double high, double share);

/// The pure colour of a hue of [0, 1): one channel is 1, one is 0, one lies between.
std::array<float, 3> hueColor(double hue);

/// Throws `HostRefused` when the user cancels.
void tellProgress(const candela_host& host, double fraction);

/// Black, not metallic, perfectly smooth, without textures: the members that matter are still to be set.
candela_material plainMaterial(const std::string& name);

/// A material of one colour for all three channels. Returns its index.
int32_t addGreyMaterial(const candela_host& host, const std::string& name, float grey, float roughness);

/// A mesh of one material. Returns its index.
int32_t addMesh(const candela_host& host, const Shape& shape, int32_t material, const std::string& name);

/// A root at the origin; `mesh` is -1 for none.
candela_node plainNode(const std::string& name, int32_t mesh);

/// A mesh of one material at the origin.
void addShape(const candela_host& host, const Shape& shape, int32_t material, const std::string& name);

/// A camera of 45 degrees in the frame of `node`, which is added too and gives it its name.
void addCamera(const candela_host& host, const candela_node& node);

/// A white point light without a node; colour and position are still to be set.
candela_light plainLight(float candela, float range);

/// Adds the lights 0 to `count` - 1 that `lightAt` makes, and tells progress.
template <typename LightAt>
void addLights(const candela_host& host, std::uint32_t count, LightAt&& lightAt) {
    constexpr std::uint32_t lightsBetweenProgress = 4096;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i % lightsBetweenProgress == 0) tellProgress(host, static_cast<double>(i) / count);
        const candela_light light = lightAt(i);
        accepted(host.add_light(host.self, &light));
    }
    tellProgress(host, 1.0);
}

}  // namespace plaza
