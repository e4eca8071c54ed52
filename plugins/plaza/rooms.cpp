#include "rooms.h"

#include "count.h"
#include "floor_plan.h"
#include "generator.h"
#include "hash.h"
#include "pushing.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace plaza {
namespace {

constexpr float lightCandela = 8.0f;
constexpr float lightRange = 3.0f;              // metres
constexpr std::uint32_t cameraRoom[] = {8, 8};  // column, row
constexpr float cameraOffset = 2.7f;            // metres from the room's middle, along x and z
constexpr float cameraHeight = 1.7f;            // metres

// Properties that are drawn by hash. The numbers are part of the scene: a change makes other rooms.
enum LightProperty : std::uint32_t { lightX, lightY, lightZ, lightHue };
enum RoomProperty : std::uint32_t { colorRed = 200, colorGreen, colorBlue, roughness, metallic };

int32_t addFurnitureMaterial(const candela_host& host, std::uint32_t room, const std::string& name) {
    candela_material material = plainMaterial(name);
    for (std::uint32_t i = 0; i < 3; ++i)
        material.base_color[i] = static_cast<float>(between(0.2, 0.95, hashedShare(room, colorRed + i)));
    material.roughness = static_cast<float>(between(0.2, 1.0, hashedShare(room, roughness)));
    material.metallic = hashedShare(room, metallic) < 0.25 ? 1.0f : 0.0f;
    return accepted(host.add_material(host.self, &material));
}

void addFloorAndCeiling(const candela_host& host) {
    constexpr std::uint32_t quads = 64;
    const std::string floor = "floor", ceiling = "ceiling";
    Shape shape = makeGround(planSide, quads);
    addShape(host, shape, addGreyMaterial(host, floor, 0.5f, 0.5f), floor);
    turnInsideOut(shape);
    for (std::array<float, 3>& position : shape.positions) position[1] = wallHeight;
    addShape(host, shape, addGreyMaterial(host, ceiling, 0.8f, 0.9f), ceiling);
}

// A mesh a room for its walls and one for its furniture, so that a view leaves out what it does not see.
void addAllRooms(const candela_host& host) {
    const std::string wall = "wall";
    const int32_t wallMaterial = addGreyMaterial(host, wall, 0.7f, 0.9f);
    addShape(host, outerWalls(), wallMaterial, "outer walls");
    for (std::uint32_t row = 0; row < roomsASide; ++row)
        for (std::uint32_t column = 0; column < roomsASide; ++column) {
            const std::string place = std::to_string(column) + "," + std::to_string(row);
            const std::string furniture = "furniture " + place;
            addShape(host, roomWalls(column, row), wallMaterial, "walls " + place);
            addShape(host, roomFurniture(column, row),
                     addFurnitureMaterial(host, roomIndex(column, row), furniture), furniture);
        }
}

// In the corner towards +X and +Z, looking through the middle of the room: turned by 45 degrees about y.
// Square roots round the same everywhere.
void addEye(const candela_host& host) {
    const double cosine = std::sqrt(0.5);
    const std::string name = "camera";
    candela_node node = plainNode(name, -1);
    node.translation[0] = roomMiddle(cameraRoom[0]) + cameraOffset;
    node.translation[1] = cameraHeight;
    node.translation[2] = roomMiddle(cameraRoom[1]) + cameraOffset;
    node.rotation[1] = static_cast<float>(std::sqrt((1.0 - cosine) / 2.0));
    node.rotation[3] = static_cast<float>(std::sqrt((1.0 + cosine) / 2.0));
    addCamera(host, node);
}

candela_light lightAt(std::uint32_t index) {
    const auto drawn = [&](LightProperty property, double low, double high) {
        return static_cast<float>(between(low, high, hashedShare(index, property)));
    };
    candela_light light = plainLight(lightCandela, lightRange);
    light.position[0] = drawn(lightX, -49.5, 49.5);
    light.position[1] = drawn(lightY, 0.3, 2.7);
    light.position[2] = drawn(lightZ, -49.5, 49.5);
    const std::array<float, 3> color = hueColor(hashedShare(index, lightHue));
    std::copy(color.begin(), color.end(), light.color);
    return light;
}

}  // namespace

void makeRooms(const candela_host& host, const std::string& arguments) {
    const std::uint32_t lights = parseCount(arguments, "number of lights", "rooms:4096");
    addFloorAndCeiling(host);
    addAllRooms(host);
    addEye(host);
    addLights(host, lights, lightAt);
}

}  // namespace plaza
