#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "geometry.h"
#include "scene_builder.h"
#include "scenes.h"

namespace candela_plugins::plaza {
namespace {

constexpr std::uint32_t columnsPerRow = 16, rows = 4;
constexpr float spacing = 3.0f;      // metres between columns
constexpr float shaftRadius = 0.4f;  // metres
constexpr float shaftHeight = 4.2f;  // metres
constexpr float slab = 0.25f;        // metres, of bases, capitals and the roof
constexpr std::uint32_t lanterns = 32;
constexpr double lanternRadius = 0.15;  // metres
constexpr float lightCandela = 0.12f;
constexpr float lightRange = 6.0f;  // metres
constexpr double twoPi = 6.28318530717958647692;

// Pseudo-random properties. The numbers are part of the scene: changing them changes it.
enum Property : std::uint32_t { lanternX = 300, lanternY, lanternZ, lanternHue, lightX, lightY, lightZ };

float columnX(std::uint32_t row) {
    return (static_cast<float>(row) - 0.5f * (rows - 1)) * spacing;
}

float columnZ(std::uint32_t place) {
    return -static_cast<float>(place) * spacing;
}

/// The side of a cylinder around the y axis.
Geometry makeShaft() {
    constexpr std::uint32_t around = 32;
    Geometry shaft;
    for (std::uint32_t i = 0; i <= around; ++i) {
        const double angle = twoPi * i / around;
        const auto x = static_cast<float>(gridSine(angle)), z = static_cast<float>(gridCosine(angle));
        for (const float y : {slab, slab + shaftHeight}) {
            shaft.positions.push_back({shaftRadius * x, y, shaftRadius * z});
            shaft.normals.push_back({x, 0.0f, z});
        }
    }
    for (std::uint32_t i = 0; i < around; ++i) {
        const std::uint32_t low = 2 * i, next = low + 2;
        shaft.indices.insert(shaft.indices.end(), {low, next, next + 1, low, next + 1, low + 1});
    }
    return shaft;
}

/// A shaft between two slabs, standing on the ground.
Geometry makeColumn() {
    constexpr float half = 1.4f * shaftRadius;
    Geometry column = makeShaft();
    addBox(column, {-half, 0.0f, -half}, {half, slab, half});
    addBox(column, {-half, slab + shaftHeight, -half}, {half, 2.0f * slab + shaftHeight, half});
    return column;
}

void addColumns(const Host& host) {
    const std::string name = "column";
    const int32_t mesh = addMesh(host, makeColumn(), addGreyMaterial(host, name, 0.75f, 0.6f), name);
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t place = 0; place < columnsPerRow; ++place) {
            const std::string nodeName = name + " " + std::to_string(row) + "," + std::to_string(place);
            candela_node node = plainNode(nodeName, mesh);
            node.translation[0] = columnX(row);
            node.translation[2] = columnZ(place);
            host.add(node);
        }
    }
}

void addGroundAndRoof(const Host& host) {
    const std::string ground = "ground", roof = "roof";
    addGeometry(host, makeGround(100.0f, 32), addGreyMaterial(host, ground, 0.5f, 0.4f), ground);
    constexpr float top = 2.0f * slab + shaftHeight, overhang = 0.8f;
    Geometry plate;
    addBox(plate, {columnX(0) - overhang, top, columnZ(columnsPerRow - 1) - overhang},
           {columnX(rows - 1) + overhang, top + slab, columnZ(0) + overhang});
    addGeometry(host, plate, addGreyMaterial(host, roof, 0.7f, 0.8f), roof);
}

// Lanterns stand between the rows. Each is a cloud of lights, whose shadows together are soft.
candela_light lightAt(std::uint32_t index) {
    const std::uint32_t lantern = index % lanterns;
    const auto placed = [&](Property ofLantern, double low, double high, Property ofLight) {
        const double middle = between(low, high, hashedFraction(lantern, ofLantern));
        return static_cast<float>(middle +
                                  between(-lanternRadius, lanternRadius, hashedFraction(index, ofLight)));
    };
    candela_light light = plainLight(lightCandela, lightRange);
    light.position[0] = placed(lanternX, -6.0, 6.0, lightX);
    light.position[1] = placed(lanternY, 0.3, 1.6, lightY);
    light.position[2] = placed(lanternZ, columnZ(columnsPerRow - 1), 1.0, lightZ);
    const std::array<float, 3> color = hueColor(hashedFraction(lantern, lanternHue));
    for (std::size_t i = 0; i < 3; ++i) light.color[i] = 0.35f + 0.65f * color[i];
    return light;
}

void addPlacedCamera(const Host& host) {
    const std::string name = "camera";
    candela_node node = plainNode(name, -1);
    node.translation[0] = 0.4f;
    node.translation[1] = 1.7f;
    node.translation[2] = 5.0f;
    addCamera(host, node);
}

}  // namespace

void makeColonnade(const Host& host, const std::string& arguments) {
    const std::uint32_t lights = parseCount(arguments, "number of lights", "colonnade:4096");
    addGroundAndRoof(host);
    addColumns(host);
    addPlacedCamera(host);
    addLights(host, lights, lightAt);
}

}  // namespace candela_plugins::plaza
