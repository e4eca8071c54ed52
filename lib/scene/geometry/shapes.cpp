#include <candela/shapes.h>

#include "base/error_context.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace candela {

namespace {

void requireParts(const ErrorContext& shape, const char* what, std::uint32_t parts, std::uint32_t least) {
    shape.requireWithin(what, parts, least, maxShapeParts);
}

/// Directions from the axis, one a column of vertices: the last one is the first one again.
std::vector<glm::dvec2> columnDirections(std::uint32_t segments) {
    std::vector<glm::dvec2> directions;
    for (std::uint32_t i = 0; i < segments; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / segments;
        // From +X towards -Z.
        directions.emplace_back(std::cos(angle), -std::sin(angle));
    }
    directions.push_back(directions.front());
    return directions;
}

/// A point of the curve that turns about Y.
struct ProfilePoint {
    double radius, y;
    glm::dvec2 normal;  ///< Away from the axis, and up.
    double v;
};

std::uint32_t vertexCount(const Mesh& mesh) {
    return static_cast<std::uint32_t>(mesh.positions.size());
}

void addVertex(Mesh& mesh, const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec2& uv) {
    mesh.positions.emplace_back(position);
    mesh.normals.emplace_back(normal);
    mesh.uv0.emplace_back(uv);
}

/// The surface that the profile, which goes downwards on the outside, turns through. On the axis each segment
/// has a vertex of its own, in the middle of its texture coordinates and with its own normal.
void addRevolution(Mesh& mesh, std::span<const ProfilePoint> profile, std::uint32_t segments) {
    const std::vector<glm::dvec2> directions = columnDirections(segments);
    std::vector<std::uint32_t> firstOfRow;
    for (const ProfilePoint& point : profile) {
        const bool onAxis = point.radius == 0.0;
        firstOfRow.push_back(vertexCount(mesh));
        for (std::uint32_t i = 0; i < segments + (onAxis ? 0 : 1); ++i) {
            const glm::dvec2 out = onAxis ? glm::normalize(directions[i] + directions[i + 1]) : directions[i];
            const double u = (i + (onAxis ? 0.5 : 0.0)) / segments;
            const glm::dvec3 normal(point.normal.x * out.x, point.normal.y, point.normal.x * out.y);
            addVertex(mesh, {point.radius * out.x, point.y, point.radius * out.y}, normal, {u, point.v});
        }
    }
    for (std::size_t row = 0; row + 1 < profile.size(); ++row) {
        const bool beginsOnAxis = profile[row].radius == 0.0, endsOnAxis = profile[row + 1].radius == 0.0;
        for (std::uint32_t i = 0; i < segments; ++i) {
            const std::uint32_t top = firstOfRow[row] + i, bottom = firstOfRow[row + 1] + i;
            if (!endsOnAxis) mesh.indices.insert(mesh.indices.end(), {top, bottom, bottom + 1});
            if (beginsOnAxis) continue;
            mesh.indices.insert(mesh.indices.end(), {top, endsOnAxis ? bottom : bottom + 1, top + 1});
        }
    }
}

enum class Facing { up, down };

void addDisc(Mesh& mesh, double radius, double y, std::uint32_t segments, Facing facing) {
    const double up = facing == Facing::up ? 1.0 : -1.0;
    const std::uint32_t center = vertexCount(mesh);
    addVertex(mesh, {0.0, y, 0.0}, {0.0, up, 0.0}, {0.5, 0.5});
    for (const glm::dvec2& out : columnDirections(segments)) {
        // From above v grows with z, from below against it.
        const glm::dvec2 uv(0.5 + 0.5 * out.x, 0.5 + 0.5 * up * out.y);
        addVertex(mesh, {radius * out.x, y, radius * out.y}, {0.0, up, 0.0}, uv);
    }
    // The last vertex is a copy of the first one.
    mesh.positions.pop_back();
    mesh.normals.pop_back();
    mesh.uv0.pop_back();
    for (std::uint32_t i = 0; i < segments; ++i) {
        const std::uint32_t here = center + 1 + i, next = center + 1 + (i + 1) % segments;
        mesh.indices.insert(mesh.indices.end(),
                            {center, facing == Facing::up ? here : next, facing == Facing::up ? next : here});
    }
}

/// With one submesh of all indices.
Mesh finished(Mesh mesh, const char* name) {
    mesh.name = name;
    mesh.submeshes.push_back({0, static_cast<std::uint32_t>(mesh.indices.size()), std::nullopt});
    return mesh;
}

}  // namespace

Mesh sphereMesh(float radius, std::uint32_t segments, std::uint32_t rings) {
    const ErrorContext shape("sphere");
    shape.requirePositive("its radius", radius);
    requireParts(shape, "its number of segments", segments, 3);
    requireParts(shape, "its number of rings", rings, 2);
    std::vector<ProfilePoint> profile;
    for (std::uint32_t i = 0; i <= rings; ++i) {
        const double angle = std::numbers::pi * i / rings;
        const bool isPole = i == 0 || i == rings;
        const glm::dvec2 normal(isPole ? 0.0 : std::sin(angle), std::cos(angle));
        profile.push_back({radius * normal.x, radius * normal.y, normal, static_cast<double>(i) / rings});
    }
    Mesh mesh;
    addRevolution(mesh, profile, segments);
    return finished(std::move(mesh), "sphere");
}

Mesh boxMesh(const glm::vec3& size) {
    const ErrorContext shape("box");
    for (int axis = 0; axis < 3; ++axis) shape.requirePositive("its size", size[axis]);
    // The normal of each side, and the direction in which u grows; v grows along cross(u, normal).
    struct Side {
        glm::dvec3 normal, u;
    };
    constexpr std::array<Side, 6> sides{{{{1, 0, 0}, {0, 0, -1}},
                                         {{-1, 0, 0}, {0, 0, 1}},
                                         {{0, 1, 0}, {1, 0, 0}},
                                         {{0, -1, 0}, {1, 0, 0}},
                                         {{0, 0, 1}, {1, 0, 0}},
                                         {{0, 0, -1}, {-1, 0, 0}}}};
    Mesh mesh;
    for (const auto& [normal, u] : sides) {
        const glm::dvec3 down = glm::cross(u, normal), half = 0.5 * glm::dvec3(size);
        const std::uint32_t first = vertexCount(mesh);
        for (const glm::dvec2 uv : {glm::dvec2(0, 0), glm::dvec2(0, 1), glm::dvec2(1, 1), glm::dvec2(1, 0)})
            addVertex(mesh, half * (normal + (2.0 * uv.x - 1.0) * u + (2.0 * uv.y - 1.0) * down), normal, uv);
        mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
    return finished(std::move(mesh), "box");
}

Mesh planeMesh(float width, float depth, std::uint32_t parts) {
    const ErrorContext shape("plane");
    shape.requirePositive("its width", width);
    shape.requirePositive("its depth", depth);
    requireParts(shape, "its number of parts", parts, 1);
    Mesh mesh;
    for (std::uint32_t row = 0; row <= parts; ++row) {
        for (std::uint32_t column = 0; column <= parts; ++column) {
            const glm::dvec2 uv(static_cast<double>(column) / parts, static_cast<double>(row) / parts);
            addVertex(mesh, {width * (uv.x - 0.5), 0.0, depth * (uv.y - 0.5)}, {0.0, 1.0, 0.0}, uv);
        }
    }
    for (std::uint32_t row = 0; row < parts; ++row) {
        for (std::uint32_t column = 0; column < parts; ++column) {
            const std::uint32_t a = row * (parts + 1) + column, b = a + parts + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    }
    return finished(std::move(mesh), "plane");
}

Mesh discMesh(float radius, std::uint32_t segments) {
    const ErrorContext shape("disc");
    shape.requirePositive("its radius", radius);
    requireParts(shape, "its number of segments", segments, 3);
    Mesh mesh;
    addDisc(mesh, radius, 0.0, segments, Facing::up);
    return finished(std::move(mesh), "disc");
}

Mesh cylinderMesh(float radius, float height, std::uint32_t segments) {
    const ErrorContext shape("cylinder");
    shape.requirePositive("its radius", radius);
    shape.requirePositive("its height", height);
    requireParts(shape, "its number of segments", segments, 3);
    const double half = 0.5 * height;
    Mesh mesh;
    const std::array<ProfilePoint, 2> side{
        {{radius, half, {1.0, 0.0}, 0.0}, {radius, -half, {1.0, 0.0}, 1.0}}};
    addRevolution(mesh, side, segments);
    addDisc(mesh, radius, half, segments, Facing::up);
    addDisc(mesh, radius, -half, segments, Facing::down);
    return finished(std::move(mesh), "cylinder");
}

Mesh coneMesh(float radius, float height, std::uint32_t segments) {
    const ErrorContext shape("cone");
    shape.requirePositive("its radius", radius);
    shape.requirePositive("its height", height);
    requireParts(shape, "its number of segments", segments, 3);
    const double half = 0.5 * height;
    const glm::dvec2 normal = glm::normalize(glm::dvec2(height, radius));
    Mesh mesh;
    const std::array<ProfilePoint, 2> side{{{0.0, half, normal, 0.0}, {radius, -half, normal, 1.0}}};
    addRevolution(mesh, side, segments);
    addDisc(mesh, radius, -half, segments, Facing::down);
    return finished(std::move(mesh), "cone");
}

Mesh torusMesh(float radius, float tubeRadius, std::uint32_t segments, std::uint32_t tubeSegments) {
    const ErrorContext shape("torus");
    shape.requirePositive("its radius", radius);
    shape.requirePositive("the radius of its tube", tubeRadius);
    shape.require(radius >= tubeRadius, "the radius of its tube must not be over its radius");
    requireParts(shape, "its number of segments", segments, 3);
    requireParts(shape, "the number of segments of its tube", tubeSegments, 3);
    std::vector<ProfilePoint> profile;
    for (std::uint32_t i = 0; i <= tubeSegments; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i % tubeSegments) / tubeSegments;
        const glm::dvec2 normal(std::sin(angle), std::cos(angle));
        profile.push_back({radius + tubeRadius * normal.x, tubeRadius * normal.y, normal,
                           static_cast<double>(i) / tubeSegments});
    }
    Mesh mesh;
    addRevolution(mesh, profile, segments);
    return finished(std::move(mesh), "torus");
}

}  // namespace candela
