#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace candela_plugins::plaza {

/// Triangles in the layout of `candela_mesh`, counter-clockwise from the front.
struct Geometry {
    std::vector<std::array<float, 3>> positions;  // metres
    std::vector<std::array<float, 3>> normals;
    std::vector<std::uint32_t> indices;
};

/// Sine and cosine that are the same on every machine: rounded to multiples of 2^-20, which hides the last
/// bits in which mathematical libraries differ. `angle` in radians.
double gridSine(double angle);
double gridCosine(double angle);

/// A square in the plane y = 0 around the origin that faces up, `side` metres wide, of `quads` × `quads`
/// quads.
Geometry makeGround(float side, std::uint32_t quads);

/// A sphere around the origin, `radius` in metres, with `around` segments about the y axis (3 or more) and
/// `down` from pole to pole (2 or more).
Geometry makeSphere(float radius, std::uint32_t around, std::uint32_t down);

/// Flips the faces and their normals.
void flipFaces(Geometry& geometry);

/// Adds an axis-aligned box with flat normals; `low` is less than `high` along each axis, metres.
void addBox(Geometry& geometry, const std::array<float, 3>& low, const std::array<float, 3>& high);

}  // namespace candela_plugins::plaza
