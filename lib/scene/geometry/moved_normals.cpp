#include "scene/geometry/moved_normals.h"

#include "scene/geometry/topology.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace candela {

namespace {

/// Position and normal of a vertex, by their bits.
std::array<std::uint32_t, 6> keyOf(const Mesh& mesh, std::uint32_t vertex) {
    // Adding 0 maps -0 to 0.
    const glm::vec3 p = mesh.positions[vertex] + 0.0f, n = mesh.normals[vertex] + 0.0f;
    std::array<std::uint32_t, 6> key{};
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        key[static_cast<std::size_t>(axis)] = std::bit_cast<std::uint32_t>(p[axis]);
        key[static_cast<std::size_t>(3 + axis)] = std::bit_cast<std::uint32_t>(n[axis]);
    }
    return key;
}

std::vector<std::uint32_t> weld(const Mesh& mesh) {
    std::vector<std::uint32_t> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t vertex) { return keyOf(mesh, vertex); });
    std::vector<std::uint32_t> first(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && keyOf(mesh, order[i]) == keyOf(mesh, order[i - 1]);
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    return first;
}

}  // namespace

MovedNormals::MovedNormals(const Mesh& rest, Vertices vertices) : restNormals_(rest.normals) {
    forEachTriangle(rest, [&](std::size_t first) {
        for (std::size_t corner = first; corner < first + 3; ++corner)
            corners_.push_back(rest.indices[corner]);
    });
    if (vertices == Vertices::welded) {
        groups_ = weld(rest);
    } else {
        groups_.resize(rest.positions.size());
        std::iota(groups_.begin(), groups_.end(), 0u);
    }
}

std::vector<glm::vec3> MovedNormals::at(std::span<const glm::vec3> positions) const {
    std::vector<glm::dvec3> sums(groups_.size(), glm::dvec3(0.0));
    for (std::size_t first = 0; first < corners_.size(); first += 3) {
        const std::array<glm::dvec3, 3> at{glm::dvec3(positions[corners_[first]]),
                                           glm::dvec3(positions[corners_[first + 1]]),
                                           glm::dvec3(positions[corners_[first + 2]])};
        const glm::dvec3 cross = glm::cross(at[1] - at[0], at[2] - at[0]);
        const double doubledArea = glm::length(cross);
        if (!(doubledArea > 0.0)) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 a = at[(i + 1) % 3] - at[i], b = at[(i + 2) % 3] - at[i];
            const double angle = std::atan2(doubledArea, glm::dot(a, b));
            sums[groups_[corners_[first + i]]] += (angle / doubledArea) * cross;
        }
    }
    std::vector<glm::vec3> normals = restNormals_;
    for (std::size_t vertex = 0; vertex < normals.size(); ++vertex) {
        const glm::dvec3& sum = sums[groups_[vertex]];
        if (glm::length(sum) > 1e-9) normals[vertex] = glm::vec3(glm::normalize(sum));
    }
    return normals;
}

}  // namespace candela
