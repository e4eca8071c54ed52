#include "base/error_context.h"
#include "base/runs.h"
#include "scene/geometry/topology.h"
#include "scene/validate/scene_rules.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace candela {

namespace {

constexpr std::size_t maxCount = std::numeric_limits<std::uint32_t>::max();

bool areBelow(const std::vector<std::uint32_t>& indices, std::size_t end) {
    std::atomic<bool> isBeyond = false;
    inRuns(indices.size(), [&](std::size_t from, std::size_t to) {
        // The maximum of a run is found three times as fast as what is beyond `end`.
        std::uint32_t maximum = 0;
        for (std::size_t i = from; i < to; ++i) maximum = std::max(maximum, indices[i]);
        if (maximum >= end) isBeyond = true;
    });
    return !isBeyond;
}

void validateArrays(const Mesh& mesh, const ErrorContext& element) {
    const std::size_t vertices = mesh.positions.size();
    const auto requireAll = [&](const auto& values, const char* what) {
        element.requireCount(what, values.size(), "vertices", vertices);
    };
    const auto requireAllOrNone = [&](const auto& values, const char* what) {
        if (!values.empty()) requireAll(values, what);
    };
    requireAll(mesh.normals, "normals");
    requireAllOrNone(mesh.tangents, "tangents");
    requireAllOrNone(mesh.uv0, "texture coordinates 0");
    requireAllOrNone(mesh.uv1, "texture coordinates 1");
    element.require(basicUvSets + mesh.furtherUvs.size() <= maxUvSets,
                    "may have 18 sets of texture coordinates at most");
    requireAllOrNone(mesh.colors, "colours");
    element.requireEachFinite("position", mesh.positions);
    element.requireEachFinite("texture coordinate 0 of vertex", mesh.uv0);
    element.requireEachFinite("texture coordinate 1 of vertex", mesh.uv1);
    for (std::size_t i = 0; i < mesh.furtherUvs.size(); ++i) {
        const std::string set = std::to_string(basicUvSets + i);
        requireAllOrNone(mesh.furtherUvs[i], ("texture coordinates " + set).c_str());
        element.requireEachFinite(("texture coordinate " + set + " of vertex").c_str(), mesh.furtherUvs[i]);
    }
    element.requireEachFinite("colour", mesh.colors);
    const bool mayLackNormals = !hasOnlyTriangles(mesh);
    element.requireEach("normal", mesh.normals, "does not have unit length", [&](const glm::vec3& normal) {
        return isUnit(normal) || (mayLackNormals && normal == glm::vec3(0.0f));
    });
    element.requireEach("tangent", mesh.tangents, "must have unit length and -1 or 1 in w",
                        [](const glm::vec4& tangent) {
                            return isUnit(glm::vec3(tangent)) && (tangent.w == 1.0f || tangent.w == -1.0f);
                        });
}

void requireMaterial(std::optional<std::uint32_t> material, const Mesh& mesh, const Scene& scene,
                     const ErrorContext& element) {
    element.requireIndex("material", material, scene.materials.size());
    if (!material || mesh.positions.empty()) return;
    requireUvs(uvSetsOf(mesh), *material, scene, element);
}

void requireWholeElements(const Submesh& submesh, const Mesh& mesh, const ErrorContext& element) {
    if (hasOnlyTriangles(mesh)) {
        return element.require(submesh.firstIndex % 3 == 0 && submesh.indexCount % 3 == 0,
                               "a submesh's first index and index count must be multiples of 3");
    }
    element.require(submesh.topology <= Topology::points, "a submesh's topology is none of the enumeration");
    element.require(submesh.indexCount % cornersOf(submesh.topology) == 0,
                    isTriangles(submesh) ? "a submesh of triangles must have a multiple of 3 indices"
                                         : "a submesh of lines must have an even number of indices");
}

/// Of meshes with lines or points, whose indices and vertices have been checked.
void requireNormals(const Submesh& submesh, const Mesh& mesh, const ErrorContext& element) {
    const bool unlit = isUnlit(mesh, submesh);
    for (std::uint32_t i = 0; i < submesh.indexCount; ++i) {
        const std::uint32_t vertex = mesh.indices[submesh.firstIndex + i];
        if ((mesh.normals[vertex] == glm::vec3(0.0f)) == unlit) continue;
        if (isTriangles(submesh))
            element.refuse("vertex " + std::to_string(vertex) + " of a triangle must have a normal");
        element.refuse(
            "a submesh of lines or points must have normals at all of its vertices or at none, but "
            "vertex " +
            std::to_string(vertex) + " differs from the first");
    }
}

void validateSubmesh(const Submesh& submesh, const Mesh& mesh, const Scene& scene,
                     const ErrorContext& element) {
    requireWholeElements(submesh, mesh, element);
    const std::uint64_t end = std::uint64_t{submesh.firstIndex} + submesh.indexCount;
    if (end > mesh.indices.size()) {
        element.refuse("a submesh ends at index " + std::to_string(end) + ", but there are " +
                       std::to_string(mesh.indices.size()));
    }
    if (!hasOnlyTriangles(mesh)) requireNormals(submesh, mesh, element);
    if (submesh.indexCount == 0)
        element.requireIndex("material", submesh.material, scene.materials.size());
    else
        requireMaterial(submesh.material, mesh, scene, element);
}

void validateVariants(const Mesh& mesh, const Scene& scene, const ErrorContext& element) {
    using Key = std::pair<std::uint32_t, std::optional<std::uint32_t>>;
    std::set<Key> known;
    for (const VariantMaterial& entry : mesh.variantMaterials) {
        element.requireIndex("variant", entry.variant, scene.variants.size());
        if (entry.submesh >= mesh.submeshes.size())
            element.refuse("a variant names submesh " + std::to_string(entry.submesh) + ", but there are " +
                           std::to_string(mesh.submeshes.size()));
        element.require(known.insert({entry.submesh, entry.variant}).second,
                        "a submesh has two materials for the same variant");
        requireMaterial(entry.material, mesh, scene, element);
    }
    for (const Key& key : known)
        element.require(known.contains({key.first, std::nullopt}),
                        "a submesh with materials for variants has none without a variant");
}

}  // namespace

void requireIndices(const Mesh& mesh, const ErrorContext& element) {
    element.require(mesh.positions.size() <= maxCount && mesh.indices.size() <= maxCount,
                    "has more vertices or indices than 32 bits can count");
    element.require(mesh.indices.size() % 3 == 0 || !hasOnlyTriangles(mesh),
                    "the number of its indices must be a multiple of 3");
    const std::size_t vertices = mesh.positions.size();
    if (areBelow(mesh.indices, vertices)) return;
    const auto beyond = std::find_if(mesh.indices.begin(), mesh.indices.end(),
                                     [vertices](std::uint32_t index) { return index >= vertices; });
    element.refuse("index " + std::to_string(beyond - mesh.indices.begin()) + " names vertex " +
                   std::to_string(*beyond) + ", but there are " + std::to_string(vertices));
}

void validateMesh(const Mesh& mesh, const Scene& scene, const ErrorContext& element) {
    requireIndices(mesh, element);
    validateArrays(mesh, element);
    const DeformableVertices shape(mesh);
    requireInfluences(shape, element);
    requireMorphTargets(shape, element);
    for (const Submesh& submesh : mesh.submeshes) validateSubmesh(submesh, mesh, scene, element);
    validateVariants(mesh, scene, element);
}

}  // namespace candela
