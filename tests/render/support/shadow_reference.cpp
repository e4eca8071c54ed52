#include "support/shadow_reference.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace candela::test {

namespace {

Visibility visibilityPast(const Triangle& triangle, const Segment& segment) {
    const auto& [from, to, eye, margin] = segment;
    const glm::dvec3 &a = triangle.corners[0], &b = triangle.corners[1], &c = triangle.corners[2];
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    if (glm::length(cross) == 0.0) return Visibility::clear;
    const glm::dvec3 normal = glm::normalize(cross);
    const double start = glm::dot(from - a, normal), end = glm::dot(to - a, normal);
    if ((start > margin && end > margin) || (start < -margin && end < -margin)) return Visibility::clear;
    if (std::abs(end) <= margin && start * glm::dot(eye - a, normal) > 0.0) return Visibility::clear;
    if (std::abs(start - end) < 1e-12) return Visibility::grazing;
    const double t = start / (start - end);
    const glm::dvec3 p = from + t * (to - from);
    // The point in the plane moves by the margin over the sine of the angle between ray and plane.
    const double sine = std::abs(start - end) / glm::length(to - from);
    const double reach = margin / std::max(sine, 1e-6);
    double inside = 1e30;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 &u = triangle.corners[k], &v = triangle.corners[(k + 1) % 3];
        const double length = glm::length(v - u);
        if (length > 0.0) inside = std::min(inside, glm::dot(glm::cross(normal, v - u), p - u) / length);
    }
    if (inside < -reach) return Visibility::clear;
    const bool crosses = std::min(start, end) < -margin && std::max(start, end) > margin;
    return crosses && inside > reach ? Visibility::blocked : Visibility::grazing;
}

}  // namespace

void addTriangles(std::vector<Triangle>& triangles, const Mesh& mesh, const glm::mat4& world, double alpha) {
    const glm::dmat4 matrix(world);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        Triangle triangle;
        triangle.alpha = alpha;
        for (std::size_t k = 0; k < 3; ++k)
            triangle.corners[k] = glm::dvec3(matrix * glm::dvec4(mesh.positions[mesh.indices[i + k]], 1.0));
        triangles.push_back(triangle);
    }
}

std::vector<Triangle> trianglesOf(const Scene& scene) {
    std::vector<Triangle> triangles;
    const std::vector<glm::mat4> world = worldTransforms(scene);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        if (!node.mesh || !node.castsShadow) continue;
        const Mesh& mesh = scene.meshes[*node.mesh];
        const std::optional<std::uint32_t> index =
            mesh.submeshes.empty() ? std::nullopt : mesh.submeshes.front().material;
        const Material material = index ? scene.materials[*index] : Material{};
        const bool blends = material.alphaMode == AlphaMode::blend;
        addTriangles(triangles, mesh, world[i], blends ? double(material.baseColor.a) : 1.0);
    }
    return triangles;
}

double marginAt(const glm::dvec3& position, const CameraView& view, int height) {
    const glm::dvec3 eye(view.worldFromCamera[3]);
    const double distance = glm::length(position - eye);
    const double pixel = 2.0 * std::tan(0.5 * view.verticalFov) * distance / height;
    const double size =
        std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z), distance});
    return 2.0 * (pixel / 256.0 + size * 0x1p-19);
}

Transmittance transmittanceOf(const std::vector<Triangle>& triangles, const Segment& segment) {
    Transmittance result;
    for (const Triangle& triangle : triangles) {
        const Visibility past = visibilityPast(triangle, segment);
        if (past == Visibility::blocked) result.share *= 1.0 - triangle.alpha;
        result.grazing = result.grazing || past == Visibility::grazing;
    }
    return result;
}

Visibility visibilityOf(const std::vector<Triangle>& triangles, const Segment& segment) {
    bool grazing = false;
    for (const Triangle& triangle : triangles) {
        const Visibility past = visibilityPast(triangle, segment);
        if (past == Visibility::blocked) return past;
        grazing = grazing || past == Visibility::grazing;
    }
    return grazing ? Visibility::grazing : Visibility::clear;
}

}  // namespace candela::test
