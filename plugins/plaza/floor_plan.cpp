#include "floor_plan.h"

#include "hash.h"
#include "pushing.h"

namespace plaza {
namespace {

constexpr float roomSide = planSide / roomsASide;
constexpr float halfThickness = 0.1f;  // metres, of a wall
constexpr std::uint32_t piecesARoom = 4;

// Properties that are drawn by hash. The numbers are part of the scene: a change makes another plan.
enum Property : std::uint32_t {
    openingKind = 100,
    openingPlace,
    pieceX,
    pieceZ,
    pieceWidth,
    pieceDepth,
    pieceHeight
};

enum class Along { x, z };

struct Opening {
    float from = 0.0f, to = 0.0f, height = 0.0f;  // metres; from and to along the wall
};

// Where the first wall of column or row `place` stands.
float wallLine(std::uint32_t place) {
    return static_cast<float>(static_cast<double>(planSide) * place / roomsASide - planSide / 2.0);
}

// A piece of the wall on the line `across`.
void addPiece(Shape& shape, Along along, float across, float from, float to, float bottom, float top) {
    if (along == Along::x)
        addBox(shape, {from, bottom, across - halfThickness}, {to, top, across + halfThickness});
    else
        addBox(shape, {across - halfThickness, bottom, from}, {across + halfThickness, top, to});
}

void addSolidWall(Shape& shape, Along along, float across, float from, float to) {
    addPiece(shape, along, across, from, to, 0.0f, wallHeight);
}

void addWallWithOpening(Shape& shape, Along along, float across, float from, const Opening& opening) {
    addSolidWall(shape, along, across, from, opening.from);
    addSolidWall(shape, along, across, opening.to, from + roomSide);
    addPiece(shape, along, across, opening.from, opening.to, opening.height, wallHeight);
}

// One wall of three is open wide, the others have a door, each up to a metre from the wall's middle.
Opening openingOf(std::uint32_t wall, float from) {
    const bool wide = hashedShare(wall, openingKind) < 1.0 / 3.0;
    const double middle = from + roomSide / 2.0 + between(-1.0, 1.0, hashedShare(wall, openingPlace));
    const double half = wide ? 1.5 : 0.6;
    return {static_cast<float>(middle - half), static_cast<float>(middle + half), wide ? 2.6f : 2.1f};
}

void addPieceOfFurniture(Shape& shape, std::uint32_t column, std::uint32_t row, std::uint32_t piece) {
    const std::uint32_t index = roomIndex(column, row) * piecesARoom + piece;
    const auto drawn = [&](Property property, double low, double high) {
        return between(low, high, hashedShare(index, property));
    };
    const double x = roomMiddle(column) + drawn(pieceX, -1.6, 1.6);
    const double z = roomMiddle(row) + drawn(pieceZ, -1.6, 1.6);
    const double halfWidth = drawn(pieceWidth, 0.2, 0.7), halfDepth = drawn(pieceDepth, 0.2, 0.7);
    addBox(shape, {static_cast<float>(x - halfWidth), 0.0f, static_cast<float>(z - halfDepth)},
           {static_cast<float>(x + halfWidth), static_cast<float>(drawn(pieceHeight, 0.4, 2.0)),
            static_cast<float>(z + halfDepth)});
}

}  // namespace

float roomMiddle(std::uint32_t place) {
    return wallLine(place) + roomSide / 2.0f;
}

Shape outerWalls() {
    Shape shape;
    for (const Along along : {Along::x, Along::z})
        addSolidWall(shape, along, planSide / 2.0f, -planSide / 2.0f, planSide / 2.0f);
    return shape;
}

Shape roomWalls(std::uint32_t column, std::uint32_t row) {
    Shape shape;
    const std::uint32_t wall = 2 * roomIndex(column, row);
    const float x = wallLine(column), z = wallLine(row);
    if (row == 0)
        addSolidWall(shape, Along::x, z, x, x + roomSide);
    else
        addWallWithOpening(shape, Along::x, z, x, openingOf(wall, x));
    if (column == 0)
        addSolidWall(shape, Along::z, x, z, z + roomSide);
    else
        addWallWithOpening(shape, Along::z, x, z, openingOf(wall + 1, z));
    return shape;
}

Shape roomFurniture(std::uint32_t column, std::uint32_t row) {
    Shape shape;
    for (std::uint32_t piece = 0; piece < piecesARoom; ++piece)
        addPieceOfFurniture(shape, column, row, piece);
    return shape;
}

}  // namespace plaza
