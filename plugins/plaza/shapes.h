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

/// A square in the plane y = 0 around the origin that faces up, `side` metres wide, of `quads` × `quads`
/// quads.
Shape makeGround(float side, std::uint32_t quads);

/// A sphere around the origin, `radius` in metres, with `around` segments about the y axis (3 or more) and
/// `down` from pole to pole (2 or more).
Shape makeSphere(float radius, std::uint32_t around, std::uint32_t down);

}  // namespace plaza
