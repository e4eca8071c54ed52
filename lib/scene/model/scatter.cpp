#include <candela/error.h>
#include <candela/scene.h>

#include "base/error_context.h"
#include "scene/geometry/topology.h"
#include "scene/model/deformation.h"
#include "scene/model/frame_callback.h"
#include "scene/validate/scene_rules.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

// The same lights on every machine: integer arithmetic, and float operations that IEEE 754 rounds exactly,
// one by one (this file is compiled without contraction to fused multiply-add).

namespace candela {

namespace {

// A bijection of 32 bits with little bias. Constants: Chris Wellons, "Prospecting for hash functions", 2018
// (lowbias32).
std::uint32_t mix(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

// A number of [0, 1) with 24 bits, which a float holds exactly.
float unitFloat(std::uint32_t key, std::uint32_t dimension) {
    return static_cast<float>(mix(key + dimension * 0x9e3779b9u) >> 8) * 0x1p-24f;
}

// Red at 0, green at 1/3, blue at 2/3; the strongest channel is 1 and the weakest 0.
glm::vec3 saturatedColor(float hue) {
    const float sector = hue * 6.0f;
    const auto whole = static_cast<int>(sector);
    const float rise = sector - static_cast<float>(whole);
    const float fall = 1.0f - rise;
    switch (whole) {
        case 0:
            return {1.0f, rise, 0.0f};
        case 1:
            return {fall, 1.0f, 0.0f};
        case 2:
            return {0.0f, 1.0f, rise};
        case 3:
            return {0.0f, fall, 1.0f};
        case 4:
            return {rise, 0.0f, 1.0f};
        default:
            return {1.0f, 0.0f, fall};
    }
}

// Interpolates by weights: the result stays within the limits, and their difference can not overflow.
float between(float low, float high, float u) {
    const float value = low * (1.0f - u) + high * u;
    return value < low ? low : value > high ? high : value;
}

void reserve(std::vector<Light>& lights, std::uint32_t count) {
    const std::string reason = "there is no memory for " + std::to_string(count) + " more lights";
    try {
        lights.reserve(lights.size() + count);
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::limit, {}, reason);
    } catch (const std::length_error&) {
        throw Error(ErrorKind::limit, {}, reason);
    }
}

/// The triangles of a scene's surfaces in world space, with their areas summed up.
class Surfaces {
  public:
    explicit Surfaces(const Scene& scene) {
        const std::vector<glm::mat4> world = worldTransforms(scene);
        for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
            const Node& node = scene.nodes[i];
            if (node.mesh) {
                const Mesh& mesh = scene.meshes[*node.mesh];
                if (isDeformed(node, mesh) || movesMesh(scene, *node.mesh)) {
                    addPosed(mesh, poseMesh(scene, i, world));
                } else {
                    addMesh(mesh, world[i]);
                }
            }
            if (node.cage) addCage(scene, i, world);
        }
    }

    bool empty() const { return triangles_.empty(); }
    double area() const { return triangles_.empty() ? 0.0 : triangles_.back().endArea; }
    float diagonal() const { return glm::distance(bounds_.min, bounds_.max); }

    struct Point {
        glm::vec3 position, normal;
    };
    /// The point at a share of the area, 0 to 1, and at `u` and `v`, 0 to 1, of the triangle there.
    Point at(double share, float u, float v) const {
        const double area = share * this->area();
        auto found = std::ranges::upper_bound(triangles_, area, {}, &Triangle::endArea);
        if (found == triangles_.end()) --found;
        // Osada et al., "Shape distributions", 2002: evenly over a triangle.
        const float root = std::sqrt(u), b = root * (1.0f - v), c = root * v;
        const glm::vec3& p = found->corner;
        const glm::vec3 position = p + b * found->edge1 + c * found->edge2;
        return {glm::clamp(position, bounds_.min, bounds_.max), found->normal};
    }

  private:
    struct Triangle {
        double endArea;  ///< Of all triangles up to and with this one, square metres.
        glm::vec3 corner, edge1, edge2;
        glm::vec3 normal;
    };

    void addMesh(const Mesh& mesh, const glm::mat4& world) {
        std::vector<glm::vec3> points;
        points.reserve(mesh.positions.size());
        for (const glm::vec3& position : mesh.positions) points.push_back(transformed(world, position));
        const glm::mat3 linear(world);
        const float facing = glm::determinant(linear) < 0.0f ? -1.0f : 1.0f;
        // The inverse transpose but for a factor over 0; defined for singular matrices too.
        const glm::mat3 normalMatrix(facing * glm::cross(linear[1], linear[2]),
                                     facing * glm::cross(linear[2], linear[0]),
                                     facing * glm::cross(linear[0], linear[1]));
        const auto add = [&](std::size_t first, std::size_t count) {
            for (std::size_t i = first; i + 2 < first + count; i += 3) {
                const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
                addTriangle(points[a], points[b], points[c],
                            normalMatrix * (mesh.normals[a] + mesh.normals[b] + mesh.normals[c]));
            }
        };
        forEachTriangleRun(mesh, add);
    }

    /// A mesh that a skin or morph targets move. A triangle keeps the side on which its normals are at rest.
    void addPosed(const Mesh& mesh, const PosedPoints& posed) {
        std::vector<glm::vec3> points;
        points.reserve(posed.points.size());
        for (const glm::vec3& point : posed.points)
            points.push_back(transformed(posed.worldFromPoints, point));
        forEachTriangleRun(mesh, [&](std::size_t first, std::size_t count) {
            for (std::size_t i = first; i + 2 < first + count; i += 3) {
                const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
                const glm::vec3 rest =
                    glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
                const float side = glm::dot(rest, mesh.normals[a] + mesh.normals[b] + mesh.normals[c]);
                const glm::vec3 facing = glm::cross(points[b] - points[a], points[c] - points[a]);
                addTriangle(points[a], points[b], points[c], side < 0.0f ? -facing : facing);
            }
        });
    }

    void addCage(const Scene& scene, std::uint32_t node, const std::vector<glm::mat4>& world) {
        const PosedPoints posed = poseCage(scene, node, world);
        std::vector<glm::vec3> points;
        points.reserve(posed.points.size());
        for (const glm::vec3& point : posed.points)
            points.push_back(transformed(posed.worldFromPoints, point));
        const Cage& cage = scene.cages[*scene.nodes[node].cage];
        std::size_t first = 0;
        for (const std::uint32_t size : cage.faceSizes) {
            for (std::size_t i = 2; i < size; ++i) {
                const glm::vec3 &a = points[cage.faceVertices[first]],
                                &b = points[cage.faceVertices[first + i - 1]],
                                &c = points[cage.faceVertices[first + i]];
                addTriangle(a, b, c, glm::cross(b - a, c - a));
            }
            first += size;
        }
    }

    static glm::vec3 transformed(const glm::mat4& world, const glm::vec3& point) {
        return glm::vec3(world * glm::vec4(point, 1.0f));
    }

    /// Lights stand on the side of `side`.
    void addTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& side) {
        const glm::dvec3 normal = glm::cross(glm::dvec3(b - a), glm::dvec3(c - a));
        const double length = glm::length(normal);
        if (!(length > 0.0) || !std::isfinite(length)) return;
        const double facing = glm::dot(normal, glm::dvec3(side)) < 0.0 ? -1.0 : 1.0;
        triangles_.push_back({area() + 0.5 * length, a, b - a, c - a, glm::vec3(normal * (facing / length))});
        for (const glm::vec3& corner : {a, b, c}) bounds_.add({corner, corner});
    }

    std::vector<Triangle> triangles_;
    Bounds bounds_;
};

void check(const LightScatter& scatter) {
    const ErrorContext context("scattered lights");
    if (scatter.range) {
        context.require(*scatter.range > 0.0f && std::isfinite(*scatter.range),
                        "their range must be finite and over 0 metres");
    }
    if (scatter.candela) {
        context.require(*scatter.candela >= 0.0f && *scatter.candela <= maxIntensity,
                        "their intensity must be from 0 to 1e20 candela");
    }
}

}  // namespace

void scatterLights(Scene& scene, const LightScatter& scatter) {
    check(scatter);
    const Surfaces surfaces(scene);
    ErrorContext("scattered lights")
        .require(!surfaces.empty(), "the scene has no surface to scatter them over");
    reserve(scene.lights, scatter.count);
    const double spacing = std::sqrt(surfaces.area() / std::max(scatter.count, 1u));
    const float range = scatter.range.value_or(static_cast<float>(2.0 * spacing));
    const float candela = scatter.candela.value_or(std::min(range * range / 10.0f, maxIntensity));
    const float reach = std::min(range, surfaces.diagonal());
    const std::uint32_t seedKey = mix(scatter.seed);
    for (std::uint32_t i = 0; i < scatter.count; ++i) {
        const std::uint32_t key = mix(seedKey ^ mix(i));
        // 48 bits, so that each of very many triangles has its share.
        const double share = unitFloat(key, 1) + unitFloat(key, 2) * 0x1p-24;
        const Surfaces::Point point = surfaces.at(share, unitFloat(key, 3), unitFloat(key, 4));
        Light& light = scene.lights.emplace_back();
        light.position = point.position + point.normal * (reach * between(0.125f, 0.5f, unitFloat(key, 5)));
        light.color = saturatedColor(unitFloat(key, 6));
        light.range = range;
        light.intensity = candela;
    }
}

}  // namespace candela
