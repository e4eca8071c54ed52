#include "import/moved_vertices.h"

#include <glm/vec2.hpp>

#include <cassert>

namespace candela {

namespace {

/// A float holds each half of a number exactly.
constexpr std::uint32_t half = 1u << 16;

std::vector<std::uint32_t> takeNumbers(Mesh& mesh) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(mesh.furtherUvs.back().size());
    for (const glm::vec2& parts : mesh.furtherUvs.back())
        numbers.push_back(static_cast<std::uint32_t>(parts.x) * half + static_cast<std::uint32_t>(parts.y));
    mesh.furtherUvs.pop_back();
    return numbers;
}

}  // namespace

void numberVertices(Mesh& mesh) {
    std::vector<glm::vec2>& numbers = mesh.furtherUvs.emplace_back();
    numbers.reserve(mesh.positions.size());
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i)
        numbers.emplace_back(static_cast<float>(i / half), static_cast<float>(i % half));
}

MovedMesh::MovedMesh(const AddedMovedMesh& added, Mesh& mesh)
    : added_(added),
      sources_(takeNumbers(mesh)),
      positions_(mesh.positions),
      normals_(mesh.normals),
      computed_(mesh, added.normals) {}

std::vector<glm::vec3> MovedMesh::spread(const std::vector<glm::vec3>& values) const {
    assert(values.size() == added_.vertices);
    std::vector<glm::vec3> spread;
    spread.reserve(sources_.size());
    for (const std::uint32_t source : sources_) spread.push_back(values[source]);
    return spread;
}

}  // namespace candela
