#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometry.h"
#include "scene_builder.h"
#include "scenes.h"

namespace candela_plugins::plaza {
namespace {

constexpr float groundSide = 100.0f;  // metres
constexpr std::uint32_t groundQuads = 64;
constexpr std::uint32_t spheresPerSide = 16;
constexpr float sphereRadius = 0.8f;  // metres
constexpr float lightCandela = 8.0f;
constexpr float lightRange = 3.0f;  // metres

// Pseudo-random properties of an element. The numbers are part of the scene: changing them changes the plaza.
enum Property : std::uint32_t { lightX, lightY, lightZ, lightHue, sphereRed, sphereGreen, sphereBlue };

// Roughness increases along x; rows along z alternate between dielectric and metal.
int32_t addSphereMaterial(const Host& host, std::uint32_t column, std::uint32_t row,
                          const std::string& name) {
    const std::uint32_t index = row * spheresPerSide + column;
    candela_material material = plainMaterial(name);
    for (std::uint32_t i = 0; i < 3; ++i)
        material.base_color[i] = static_cast<float>(between(0.2, 0.95, hashedFraction(index, sphereRed + i)));
    material.metallic = row % 2 == 0 ? 0.0f : 1.0f;
    material.roughness =
        static_cast<float>(between(0.05, 1.0, static_cast<double>(column) / (spheresPerSide - 1)));
    return host.add(material);
}

void addGround(const Host& host) {
    const std::string name = "ground";
    const int32_t material = addGreyMaterial(host, name, 0.75f, 0.8f);
    addGeometry(host, makeGround(groundSide, groundQuads), material, name);
}

// The material belongs to the submesh, so every sphere is a separate mesh: 256 × 20 kB.
void addSpheres(const Host& host) {
    const Geometry geometry = makeSphere(sphereRadius, 32, 16);
    const auto center = [](std::uint32_t i) {
        return static_cast<float>(groundSide * ((i + 0.5) / spheresPerSide - 0.5));
    };
    for (std::uint32_t row = 0; row < spheresPerSide; ++row)
        for (std::uint32_t column = 0; column < spheresPerSide; ++column) {
            const std::string name = "sphere " + std::to_string(column) + "," + std::to_string(row);
            const int32_t material = addSphereMaterial(host, column, row, name);
            candela_node node = plainNode(name, addMesh(host, geometry, material, name));
            node.translation[0] = center(column);
            node.translation[1] = sphereRadius;
            node.translation[2] = center(row);
            host.add(node);
        }
}

candela_light lightAt(std::uint32_t index) {
    const auto drawn = [&](Property property, double low, double high) {
        return static_cast<float>(between(low, high, hashedFraction(index, property)));
    };
    candela_light light = plainLight(lightCandela, lightRange);
    light.position[0] = drawn(lightX, -48.0, 48.0);
    light.position[1] = drawn(lightY, 0.3, 3.0);
    light.position[2] = drawn(lightZ, -48.0, 48.0);
    const std::array<float, 3> color = hueColor(hashedFraction(index, lightHue));
    std::copy(color.begin(), color.end(), light.color);
    return light;
}

}  // namespace

void makePlaza(const Host& host, const std::string& arguments) {
    const std::uint32_t lights = parseCount(arguments, "number of lights", "plaza:4096");
    addGround(host);
    addSpheres(host);
    addCameraAt(host, 12.0, 45.0);
    addLights(host, lights, lightAt);
}

}  // namespace candela_plugins::plaza
