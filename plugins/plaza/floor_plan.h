#pragma once

#include "shapes.h"

#include <cstdint>

namespace plaza {

constexpr std::uint32_t roomsASide = 16;
constexpr float planSide = 100.0f;  // metres, around the origin
constexpr float wallHeight = 3.0f;  // metres

constexpr std::uint32_t roomIndex(std::uint32_t column, std::uint32_t row) {
    return row * roomsASide + column;
}

/// The middle of a column of rooms along x, or of a row along z, metres.
float roomMiddle(std::uint32_t place);

/// The walls around the whole plan towards +X and +Z; those towards -X and -Z belong to the first rooms.
Shape outerWalls();

/// A room's walls towards -X and -Z, each with a doorway where another room lies behind it.
Shape roomWalls(std::uint32_t column, std::uint32_t row);

/// Four boxes that leave a way along the walls.
Shape roomFurniture(std::uint32_t column, std::uint32_t row);

}  // namespace plaza
