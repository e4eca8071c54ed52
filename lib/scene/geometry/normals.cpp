#include "scene/geometry/normals.h"

#include "base/error_context.h"
#include "base/runs.h"
#include "scene/geometry/topology.h"
#include "scene/validate/scene_rules.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <optional>

namespace candela {

namespace {

constexpr glm::vec3 up(0.0f, 1.0f, 0.0f);
constexpr double minLength = 1e-12;

// In double precision, where the products of any finite floats neither overflow nor vanish.
std::optional<glm::vec3> geometricNormal(const Mesh& mesh, std::size_t firstIndex) {
    const glm::dvec3 a(mesh.positions[mesh.indices[firstIndex]]);
    const glm::dvec3 b(mesh.positions[mesh.indices[firstIndex + 1]]);
    const glm::dvec3 c(mesh.positions[mesh.indices[firstIndex + 2]]);
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double length = glm::length(cross);
    if (!(length > 0.0) || !std::isfinite(length)) return {};
    return glm::vec3(cross / length);
}

template <typename Value>
void copyToCorners(std::vector<Value>& values, const Mesh& mesh, std::size_t vertices,
                   const ErrorContext& element) {
    if (values.empty()) return;
    element.require(values.size() == vertices, "an array has neither no element nor one per vertex");
    std::vector<Value> corners;
    corners.reserve(mesh.indices.size());
    for (const std::uint32_t index : mesh.indices) corners.push_back(values[index]);
    values = std::move(corners);
}

// The values of `width` elements per vertex.
template <typename Value>
void copyRowsToCorners(std::vector<Value>& values, std::size_t width, const Mesh& mesh, std::size_t vertices,
                       const ErrorContext& element) {
    element.require(values.size() == vertices * width, "an array of joints does not fit the vertices");
    std::vector<Value> corners;
    corners.reserve(mesh.indices.size() * width);
    for (const std::uint32_t index : mesh.indices) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(index * width);
        corners.insert(corners.end(), first, first + static_cast<std::ptrdiff_t>(width));
    }
    values = std::move(corners);
}

void copyDeformersToCorners(Mesh& mesh, std::size_t vertices, const ErrorContext& element) {
    copyRowsToCorners(mesh.joints, mesh.influenceCount, mesh, vertices, element);
    copyRowsToCorners(mesh.jointWeights, mesh.influenceCount, mesh, vertices, element);
    for (MorphTarget& target : mesh.morphTargets) {
        copyToCorners(target.offsets, mesh, vertices, element);
        target.tangentOffsets.clear();
    }
}

// How the flat normal of each corner changes where a target has the weight 1. Positions, normals and offsets
// have one element per corner.
std::vector<glm::vec3> flatNormalOffsets(const Mesh& mesh, const MorphTarget& target) {
    Mesh moved;
    moved.positions = mesh.positions;
    moved.indices = mesh.indices;
    for (std::size_t i = 0; i < moved.positions.size(); ++i) moved.positions[i] += target.offsets[i];
    std::vector<glm::vec3> offsets(mesh.indices.size(), glm::vec3(0.0f));
    forEachTriangle(mesh, [&](std::size_t first) {
        const std::optional<glm::vec3> normal = geometricNormal(moved, first);
        if (!normal) return;
        for (std::size_t corner = first; corner < first + 3; ++corner)
            offsets[corner] = *normal - mesh.normals[corner];
    });
    return offsets;
}

}  // namespace

void generateFlatNormals(Mesh& mesh) {
    const ErrorContext element("mesh", {}, mesh.name);
    requireIndices(mesh, element);
    const std::size_t vertices = mesh.positions.size();
    if (!hasTriangles(mesh)) {
        mesh.normals.assign(vertices, glm::vec3(0.0f));
        mesh.tangents.clear();
        for (MorphTarget& target : mesh.morphTargets) target.normalOffsets.clear();
        return;
    }
    std::vector<glm::vec3> normals(mesh.indices.size(), glm::vec3(0.0f));
    forEachTriangle(mesh, [&](std::size_t corner) {
        const glm::vec3 normal = geometricNormal(mesh, corner).value_or(up);
        normals[corner] = normals[corner + 1] = normals[corner + 2] = normal;
    });
    copyToCorners(mesh.uv0, mesh, vertices, element);
    copyToCorners(mesh.uv1, mesh, vertices, element);
    for (auto& uvs : mesh.furtherUvs) copyToCorners(uvs, mesh, vertices, element);
    copyToCorners(mesh.colors, mesh, vertices, element);
    copyDeformersToCorners(mesh, vertices, element);
    copyToCorners(mesh.positions, mesh, vertices, element);
    mesh.normals = std::move(normals);
    mesh.tangents.clear();
    for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
        mesh.indices[corner] = static_cast<std::uint32_t>(corner);
    }
    for (MorphTarget& target : mesh.morphTargets) target.normalOffsets = flatNormalOffsets(mesh, target);
}

std::uint32_t replaceZeroNormals(Mesh& mesh) {
    const ErrorContext element("mesh", {}, mesh.name);
    requireIndices(mesh, element);
    element.require(mesh.normals.size() == mesh.positions.size(), "there must be one normal per vertex");
    const auto isDirection = [](const glm::vec3& normal) {
        return allFinite(normal) && glm::length(glm::dvec3(normal)) >= minLength;
    };
    if (holdsForAll(mesh.normals, isDirection)) return 0;
    std::vector<bool> missing(mesh.normals.size());
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        if (isDirection(mesh.normals[i])) continue;
        missing[i] = true;
        mesh.normals[i] = up;
        ++count;
    }
    forEachTriangle(mesh, [&](std::size_t first) {
        for (std::size_t corner = first; corner < first + 3; ++corner) {
            const std::uint32_t vertex = mesh.indices[corner];
            if (!missing[vertex]) continue;
            const std::optional<glm::vec3> normal = geometricNormal(mesh, first);
            if (!normal) continue;
            mesh.normals[vertex] = *normal;
            missing[vertex] = false;
        }
    });
    return count;
}

}  // namespace candela
