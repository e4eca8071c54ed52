#include "scene/geometry/mesh_indices.h"
#include "scene/validate/require_each.h"
#include "scene/validate/validate_parts.h"

#include <algorithm>
#include <limits>

namespace candela {

namespace {

constexpr std::size_t maxCount = std::numeric_limits<std::uint32_t>::max();

enum class Absence { allowed, forbidden };

template <typename Value>
void requireCount(const std::vector<Value>& values, const char* what, Absence absence, const Mesh& mesh,
                  const ErrorContext& element) {
    if (values.size() == mesh.positions.size() || (values.empty() && absence == Absence::allowed)) return;
    element.refuse("has " + std::to_string(values.size()) + " " + what + " for " +
                   std::to_string(mesh.positions.size()) + " vertices");
}

void validateArrays(const Mesh& mesh, const ErrorContext& element) {
    requireCount(mesh.normals, "normals", Absence::forbidden, mesh, element);
    requireCount(mesh.tangents, "tangents", Absence::allowed, mesh, element);
    requireCount(mesh.uv0, "texture coordinates 0", Absence::allowed, mesh, element);
    requireCount(mesh.uv1, "texture coordinates 1", Absence::allowed, mesh, element);
    requireCount(mesh.colors, "colours", Absence::allowed, mesh, element);
    requireFinite(mesh.positions, "position", element);
    requireFinite(mesh.uv0, "texture coordinate 0 of vertex", element);
    requireFinite(mesh.uv1, "texture coordinate 1 of vertex", element);
    requireFinite(mesh.colors, "colour", element);
    requireEach(mesh.normals, "normal", "does not have unit length", element, isUnit);
    requireEach(mesh.tangents, "tangent", "must have unit length and -1 or 1 in w", element,
                [](const glm::vec4& tangent) {
                    return isUnit(glm::vec3(tangent)) && (tangent.w == 1.0f || tangent.w == -1.0f);
                });
}

void validateSubmesh(const Submesh& submesh, const Mesh& mesh, const Scene& scene,
                     const ErrorContext& element) {
    element.require(submesh.firstIndex % 3 == 0 && submesh.indexCount % 3 == 0,
                    "a submesh's first index and index count must be multiples of 3");
    const std::uint64_t end = std::uint64_t{submesh.firstIndex} + submesh.indexCount;
    if (end > mesh.indices.size()) {
        element.refuse("a submesh ends at index " + std::to_string(end) + ", but there are " +
                       std::to_string(mesh.indices.size()));
    }
    element.requireIndex("material", submesh.material, scene.materials.size());
    if (!submesh.material || submesh.indexCount == 0) return;
    if (mesh.positions.empty()) return;
    requireUvs({.set0 = !mesh.uv0.empty(), .set1 = !mesh.uv1.empty()}, *submesh.material, scene, element);
}

}  // namespace

void requireIndices(const Mesh& mesh, const ErrorContext& element) {
    element.require(mesh.positions.size() <= maxCount && mesh.indices.size() <= maxCount,
                    "has more vertices or indices than 32 bits can count");
    element.require(mesh.indices.size() % 3 == 0, "the number of its indices must be a multiple of 3");
    const std::size_t vertices = mesh.positions.size();
    const auto beyond = std::find_if(mesh.indices.begin(), mesh.indices.end(),
                                     [vertices](std::uint32_t index) { return index >= vertices; });
    if (beyond == mesh.indices.end()) return;
    element.refuse("index " + std::to_string(beyond - mesh.indices.begin()) + " names vertex " +
                   std::to_string(*beyond) + ", but there are " + std::to_string(vertices));
}

void validateMesh(const Mesh& mesh, const Scene& scene, const ErrorContext& element) {
    requireIndices(mesh, element);
    validateArrays(mesh, element);
    for (const Submesh& submesh : mesh.submeshes) validateSubmesh(submesh, mesh, scene, element);
}

}  // namespace candela
