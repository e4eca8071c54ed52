#include "geometry.h"

#include <cmath>
#include <utility>

namespace candela_plugins::plaza {

namespace {

constexpr double pi = 3.14159265358979323846;

double onGrid(double value) {
    return std::floor(value * 1048576.0 + 0.5) / 1048576.0;
}

void addVertex(Geometry& sphere, double x, double y, double z, double radius) {
    sphere.normals.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
    sphere.positions.push_back(
        {static_cast<float>(x * radius), static_cast<float>(y * radius), static_cast<float>(z * radius)});
}

void addTriangle(Geometry& geometry, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    geometry.indices.insert(geometry.indices.end(), {a, b, c});
}

}  // namespace

double gridSine(double angle) {
    return onGrid(std::sin(angle));
}

double gridCosine(double angle) {
    return onGrid(std::cos(angle));
}

Geometry makeGround(float side, std::uint32_t quads) {
    Geometry ground;
    const auto at = [&](std::uint32_t i) {
        return static_cast<float>(static_cast<double>(side) * (static_cast<double>(i) / quads - 0.5));
    };
    for (std::uint32_t row = 0; row <= quads; ++row)
        for (std::uint32_t column = 0; column <= quads; ++column) {
            ground.positions.push_back({at(column), 0.0f, at(row)});
            ground.normals.push_back({0.0f, 1.0f, 0.0f});
        }
    for (std::uint32_t row = 0; row < quads; ++row)
        for (std::uint32_t column = 0; column < quads; ++column) {
            const std::uint32_t corner = row * (quads + 1) + column, below = corner + quads + 1;
            addTriangle(ground, corner, below, below + 1);
            addTriangle(ground, corner, below + 1, corner + 1);
        }
    return ground;
}

// Vertex 0 is the upper pole, then come the rings from above, each from +Z towards +X, and last the lower
// pole.
Geometry makeSphere(float radius, std::uint32_t around, std::uint32_t down) {
    Geometry sphere;
    addVertex(sphere, 0.0, 1.0, 0.0, radius);
    for (std::uint32_t ring = 1; ring < down; ++ring)
        for (std::uint32_t segment = 0; segment < around; ++segment) {
            const double polar = pi * ring / down, azimuth = 2.0 * pi * segment / around;
            addVertex(sphere, onGrid(gridSine(polar) * gridSine(azimuth)), gridCosine(polar),
                      onGrid(gridSine(polar) * gridCosine(azimuth)), radius);
        }
    addVertex(sphere, 0.0, -1.0, 0.0, radius);

    const auto vertex = [&](std::uint32_t ring, std::uint32_t segment) {
        return 1 + (ring - 1) * around + segment % around;
    };
    const auto lowerPole = static_cast<std::uint32_t>(sphere.positions.size() - 1);
    for (std::uint32_t segment = 0; segment < around; ++segment) {
        addTriangle(sphere, 0, vertex(1, segment), vertex(1, segment + 1));
        for (std::uint32_t ring = 1; ring + 1 < down; ++ring) {
            addTriangle(sphere, vertex(ring, segment), vertex(ring + 1, segment),
                        vertex(ring + 1, segment + 1));
            addTriangle(sphere, vertex(ring, segment), vertex(ring + 1, segment + 1),
                        vertex(ring, segment + 1));
        }
        addTriangle(sphere, vertex(down - 1, segment), lowerPole, vertex(down - 1, segment + 1));
    }
    return sphere;
}

void flipFaces(Geometry& geometry) {
    for (std::array<float, 3>& normal : geometry.normals)
        for (float& part : normal) part = -part;
    for (std::size_t i = 0; i < geometry.indices.size(); i += 3)
        std::swap(geometry.indices[i + 1], geometry.indices[i + 2]);
}

// For each axis the other two are a right-handed pair; the face at the low end has the opposite winding.
void addBox(Geometry& geometry, const std::array<float, 3>& low, const std::array<float, 3>& high) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool atHigh : {false, true}) {
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            const auto first = static_cast<std::uint32_t>(geometry.positions.size());
            std::array<float, 3> normal{};
            normal[axis] = atHigh ? 1.0f : -1.0f;
            for (const auto& [alongU, alongV] :
                 {std::pair{false, false}, {true, false}, {true, true}, {false, true}}) {
                std::array<float, 3> corner{};
                corner[axis] = (atHigh ? high : low)[axis];
                corner[u] = (alongU ? high : low)[u];
                corner[v] = (alongV ? high : low)[v];
                geometry.positions.push_back(corner);
                geometry.normals.push_back(normal);
            }
            const std::uint32_t second = atHigh ? 1 : 3, fourth = atHigh ? 3 : 1;
            addTriangle(geometry, first, first + second, first + 2);
            addTriangle(geometry, first, first + 2, first + fourth);
        }
}

}  // namespace candela_plugins::plaza
