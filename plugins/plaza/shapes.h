#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace plaza {

/// Triangles, counter-clockwise from the front, ready to be pushed.
struct Shape {
    std::vector<std::array<float, 3>> positions;  // metres
    std::vector<std::array<float, 3>> normals;
    std::vector<std::uint32_t> indices;
};

/// Sine and cosine that are the same on every machine: rounded to a grid of 2^-20, on which the last bits in
/// which mathematical libraries differ do not show. `angle` in radians.
double gridSine(double angle);
double gridCosine(double angle);

/// A square in the plane y = 0 around the origin that faces up, `side` metres wide, of `quads` × `quads`
/// quads.
Shape makeGround(float side, std::uint32_t quads);

/// A sphere around the origin, `radius` in metres, with `around` segments about the y axis (3 or more) and
/// `down` from pole to pole (2 or more).
Shape makeSphere(float radius, std::uint32_t around, std::uint32_t down);

/// Makes the faces of a shape look the other way.
void turnInsideOut(Shape& shape);

/// Adds a box along the axes with a normal a face; `low` is less than `high` along each axis, metres.
void addBox(Shape& shape, const std::array<float, 3>& low, const std::array<float, 3>& high);

}  // namespace plaza
