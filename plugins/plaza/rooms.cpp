#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry.h"
#include "scene_builder.h"
#include "scenes.h"

namespace candela_plugins::plaza {
namespace {

constexpr std::uint32_t roomsPerSide = 16;
constexpr float planSide = 100.0f;  // metres, around the origin
constexpr float wallHeight = 3.0f;  // metres

constexpr std::uint32_t roomIndex(std::uint32_t column, std::uint32_t row) {
    return row * roomsPerSide + column;
}

constexpr float roomSide = planSide / roomsPerSide;
constexpr float halfThickness = 0.1f;  // metres, of a wall
constexpr std::uint32_t boxesPerRoom = 4;

// Pseudo-random properties. The numbers are part of the scene: changing them changes the floor plan.
enum Property : std::uint32_t { openingKind = 100, openingPlace, boxX, boxZ, boxWidth, boxDepth, boxHeight };

enum class Along { x, z };

struct Opening {
    float from = 0.0f, to = 0.0f, height = 0.0f;  // metres; from and to along the wall
};

// The coordinate of the first wall of a column or row.
float wallLine(std::uint32_t place) {
    return static_cast<float>(static_cast<double>(planSide) * place / roomsPerSide - planSide / 2.0);
}

// The middle of a column of rooms along x, or of a row along z, metres.
float roomMiddle(std::uint32_t place) {
    return wallLine(place) + roomSide / 2.0f;
}

// A part of the wall on the line `across`.
void addWallPart(Geometry& geometry, Along along, float across, float from, float to, float bottom,
                 float top) {
    if (along == Along::x)
        addBox(geometry, {from, bottom, across - halfThickness}, {to, top, across + halfThickness});
    else
        addBox(geometry, {across - halfThickness, bottom, from}, {across + halfThickness, top, to});
}

void addSolidWall(Geometry& geometry, Along along, float across, float from, float to) {
    addWallPart(geometry, along, across, from, to, 0.0f, wallHeight);
}

void addWallWithOpening(Geometry& geometry, Along along, float across, float from, const Opening& opening) {
    addSolidWall(geometry, along, across, from, opening.from);
    addSolidWall(geometry, along, across, opening.to, from + roomSide);
    addWallPart(geometry, along, across, opening.from, opening.to, opening.height, wallHeight);
}

// A third of the walls has a wide opening, the others a door, up to a metre off the middle of the wall.
Opening openingOf(std::uint32_t wall, float from) {
    const bool wide = hashedFraction(wall, openingKind) < 1.0 / 3.0;
    const double middle = from + roomSide / 2.0 + between(-1.0, 1.0, hashedFraction(wall, openingPlace));
    const double half = wide ? 1.5 : 0.6;
    return {static_cast<float>(middle - half), static_cast<float>(middle + half), wide ? 2.6f : 2.1f};
}

void addBoxOfRoom(Geometry& geometry, std::uint32_t column, std::uint32_t row, std::uint32_t box) {
    const std::uint32_t index = roomIndex(column, row) * boxesPerRoom + box;
    const auto drawn = [&](Property property, double low, double high) {
        return between(low, high, hashedFraction(index, property));
    };
    const double x = roomMiddle(column) + drawn(boxX, -1.6, 1.6);
    const double z = roomMiddle(row) + drawn(boxZ, -1.6, 1.6);
    const double halfWidth = drawn(boxWidth, 0.2, 0.7), halfDepth = drawn(boxDepth, 0.2, 0.7);
    addBox(geometry, {static_cast<float>(x - halfWidth), 0.0f, static_cast<float>(z - halfDepth)},
           {static_cast<float>(x + halfWidth), static_cast<float>(drawn(boxHeight, 0.4, 2.0)),
            static_cast<float>(z + halfDepth)});
}

// The walls around the whole plan towards +X and +Z; those towards -X and -Z belong to the first rooms.
Geometry outerWalls() {
    Geometry geometry;
    for (const Along along : {Along::x, Along::z})
        addSolidWall(geometry, along, planSide / 2.0f, -planSide / 2.0f, planSide / 2.0f);
    return geometry;
}

// The walls of a room towards -X and -Z, each with a doorway where there is a room behind it.
Geometry roomWalls(std::uint32_t column, std::uint32_t row) {
    Geometry geometry;
    const std::uint32_t wall = 2 * roomIndex(column, row);
    const float x = wallLine(column), z = wallLine(row);
    if (row == 0)
        addSolidWall(geometry, Along::x, z, x, x + roomSide);
    else
        addWallWithOpening(geometry, Along::x, z, x, openingOf(wall, x));
    if (column == 0)
        addSolidWall(geometry, Along::z, x, z, z + roomSide);
    else
        addWallWithOpening(geometry, Along::z, x, z, openingOf(wall + 1, z));
    return geometry;
}

// Four boxes, with free space along the walls.
Geometry roomFurniture(std::uint32_t column, std::uint32_t row) {
    Geometry geometry;
    for (std::uint32_t box = 0; box < boxesPerRoom; ++box) addBoxOfRoom(geometry, column, row, box);
    return geometry;
}

constexpr float lightCandela = 8.0f;
constexpr float lightRange = 3.0f;              // metres
constexpr std::uint32_t cameraRoom[] = {8, 8};  // column, row
constexpr float cameraOffset = 2.7f;            // metres from the room's middle, along x and z
constexpr float cameraHeight = 1.7f;            // metres

// Pseudo-random properties. The numbers are part of the scene: changing them changes the rooms.
enum LightProperty : std::uint32_t { lightX, lightY, lightZ, lightHue };
enum RoomProperty : std::uint32_t { colorRed = 200, colorGreen, colorBlue, roughness, metallic };

int32_t addFurnitureMaterial(const Host& host, std::uint32_t room, const std::string& name) {
    candela_material material = plainMaterial(name);
    for (std::uint32_t i = 0; i < 3; ++i)
        material.base_color[i] = static_cast<float>(between(0.2, 0.95, hashedFraction(room, colorRed + i)));
    material.roughness = static_cast<float>(between(0.2, 1.0, hashedFraction(room, roughness)));
    material.metallic = hashedFraction(room, metallic) < 0.25 ? 1.0f : 0.0f;
    return host.add(material);
}

void addFloorAndCeiling(const Host& host) {
    constexpr std::uint32_t quads = 64;
    const std::string floor = "floor", ceiling = "ceiling";
    Geometry geometry = makeGround(planSide, quads);
    addGeometry(host, geometry, addGreyMaterial(host, floor, 0.5f, 0.5f), floor);
    flipFaces(geometry);
    for (std::array<float, 3>& position : geometry.positions) position[1] = wallHeight;
    addGeometry(host, geometry, addGreyMaterial(host, ceiling, 0.8f, 0.9f), ceiling);
}

// A mesh for the walls and one for the furniture of each room, so that they can be culled.
void addAllRooms(const Host& host) {
    const std::string wall = "wall";
    const int32_t wallMaterial = addGreyMaterial(host, wall, 0.7f, 0.9f);
    addGeometry(host, outerWalls(), wallMaterial, "outer walls");
    for (std::uint32_t row = 0; row < roomsPerSide; ++row)
        for (std::uint32_t column = 0; column < roomsPerSide; ++column) {
            const std::string place = std::to_string(column) + "," + std::to_string(row);
            const std::string furniture = "furniture " + place;
            addGeometry(host, roomWalls(column, row), wallMaterial, "walls " + place);
            addGeometry(host, roomFurniture(column, row),
                        addFurnitureMaterial(host, roomIndex(column, row), furniture), furniture);
        }
}

// In the corner towards +X and +Z, looking through the middle of the room: rotated by 45 degrees about y.
// Square roots round the same on every machine.
void addPlacedCamera(const Host& host) {
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
        return static_cast<float>(between(low, high, hashedFraction(index, property)));
    };
    candela_light light = plainLight(lightCandela, lightRange);
    light.position[0] = drawn(lightX, -49.5, 49.5);
    light.position[1] = drawn(lightY, 0.3, 2.7);
    light.position[2] = drawn(lightZ, -49.5, 49.5);
    const std::array<float, 3> color = hueColor(hashedFraction(index, lightHue));
    std::copy(color.begin(), color.end(), light.color);
    return light;
}

}  // namespace

void makeRooms(const Host& host, const std::string& arguments) {
    const std::uint32_t lights = parseCount(arguments, "number of lights", "rooms:4096");
    addFloorAndCeiling(host);
    addAllRooms(host);
    addPlacedCamera(host);
    addLights(host, lights, lightAt);
}

}  // namespace candela_plugins::plaza
