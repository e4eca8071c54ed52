#include "import/abi_import.h"

#include "base/runs.h"
#include "import/abi_reader.h"
#include "import/import_deformation.h"
#include "import/moved_vertices.h"
#include "scene/geometry/axes.h"
#include "scene/geometry/normals.h"
#include "scene/geometry/topology.h"
#include "scene/geometry/triangulate.h"
#include "scene/model/uv_sets.h"

#include <candela/error.h>
#include <candela/geometry.h>
#include <candela/mesh.h>
#include <candela/plugin.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace candela {
namespace {

/// The faces of a mesh that has `face_sizes`. Corners are counted face after face.
class PolygonFaces {
  public:
    /// Refuses faces of less than three corners, and sizes that do not add up to index_count.
    PolygonFaces(const candela_mesh& source, const AbiReader& element);

    /// Triangulates the faces. The mesh's indices are a vertex a corner, and in range.
    void triangulateFaces(Mesh& mesh) const;

    /// `run`, whose corners have to begin and end between two faces, in indices of the triangulated mesh.
    /// Messages call it `label`: "submesh 0".
    Submesh translated(const Submesh& run, const std::string& label) const;

  private:
    std::uint32_t faceBeginningAt(std::uint64_t corner, const std::string& what) const;
    std::uint32_t indexOf(std::uint32_t face) const;

    const AbiReader& element_;
    std::vector<std::uint32_t> starts_;  // The first corner of each face, and the number of all corners.
};

PolygonFaces::PolygonFaces(const candela_mesh& source, const AbiReader& element) : element_(element) {
    starts_.reserve(std::size_t{source.face_count} + 1);
    std::uint64_t end = 0;
    for (std::uint32_t face = 0; face < source.face_count; ++face) {
        const std::uint32_t size = source.face_sizes[face];
        if (size < 3)
            element.refuse(joined("face ", face, " has ", size, " corners, but 3 or more were expected"));
        starts_.push_back(static_cast<std::uint32_t>(end));
        end += size;
        // A larger `end` does not fit `starts_`.
        if (end > source.index_count) break;
    }
    if (end != source.index_count)
        element.refuse(joined("its face_sizes add up to ", end > source.index_count ? "more than " : "",
                              std::min<std::uint64_t>(end, source.index_count), ", but index_count is ",
                              source.index_count));
    starts_.push_back(source.index_count);
    if (3 * (end - 2 * std::uint64_t{source.face_count}) > std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorKind::limit, "",
                    element.label() + ": triangulated it has more indices than 32 bits can count");
}

void PolygonFaces::triangulateFaces(Mesh& mesh) const {
    const auto faces = static_cast<std::uint32_t>(starts_.size() - 1);
    std::vector<std::uint32_t> cut, triangles;
    std::vector<glm::vec3> corners;
    cut.reserve(indexOf(faces));
    for (std::uint32_t face = 0; face < faces; ++face) {
        const std::uint32_t* vertices = mesh.indices.data() + starts_[face];
        corners.clear();
        triangles.clear();
        for (std::uint32_t i = 0; i < starts_[face + 1] - starts_[face]; ++i)
            corners.push_back(mesh.positions[vertices[i]]);
        triangulate(corners, triangles);
        for (const std::uint32_t corner : triangles) cut.push_back(vertices[corner]);
    }
    mesh.indices = std::move(cut);
}

// A face of n corners is n - 2 triangles.
std::uint32_t PolygonFaces::indexOf(std::uint32_t face) const {
    return 3 * (starts_[face] - 2 * face);
}

std::uint32_t PolygonFaces::faceBeginningAt(std::uint64_t corner, const std::string& what) const {
    const auto after = std::upper_bound(starts_.begin(), starts_.end(), corner);
    const auto face = static_cast<std::uint32_t>(after - starts_.begin() - 1);
    if (starts_[face] != corner)
        element_.refuse(joined(what, corner, ", which is within face ", face,
                               ", but the boundary of a face was expected"));
    return face;
}

Submesh PolygonFaces::translated(const Submesh& run, const std::string& label) const {
    const std::uint64_t end = std::uint64_t{run.firstIndex} + run.indexCount;
    if (end > starts_.back())
        element_.refuse(
            joined(label, " ends at index ", end, ", but there are ", starts_.back(), " indices"));
    const std::uint32_t first = indexOf(faceBeginningAt(run.firstIndex, label + " begins at index "));
    const std::uint32_t last = indexOf(faceBeginningAt(end, label + " ends at index "));
    return {first, last - first, run.material, Topology::triangles};
}

// Lengths are computed in double precision, where the square of no float overflows or vanishes.

// Normalises the normals. One of length 0 or not finite becomes the normal of a face that uses the vertex.
// Returns the number of those.
std::size_t repairNormals(Mesh& mesh) {
    if (mesh.normals.empty()) return 0;
    const std::size_t replaced = replaceZeroNormals(mesh);
    inRuns(mesh.normals.size(), [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i)
            mesh.normals[i] = glm::vec3(glm::normalize(glm::dvec3(mesh.normals[i])));
    });
    return replaced;
}

// Normalises the tangents, and sets their signs to -1 or 1 (0 counts as 1). One of length 0 or not finite
// becomes a direction perpendicular to the normal, which has unit length. Returns the number of those.
std::size_t repairTangents(Mesh& mesh) {
    std::size_t replaced = 0;
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
        glm::vec4& tangent = mesh.tangents[i];
        glm::dvec3 direction(tangent);
        if (const double length = glm::length(direction); !(length > 0.0) || !std::isfinite(length)) {
            direction = anyPerpendicular(glm::dvec3(mesh.normals[i]));
            ++replaced;
        }
        tangent = glm::vec4(glm::vec3(glm::normalize(direction)), tangent.w < 0.0f ? -1.0f : 1.0f);
    }
    return replaced;
}

void takeFurtherUvs(const candela_mesh& source, const AbiReader& element, Mesh& mesh) {
    constexpr std::uint32_t most = maxUvSets - basicUvSets;
    const std::uint32_t count = element.below("further_uv_count", source.further_uv_count, most + 1);
    if (count > 0 && !source.further_uvs)
        element.refuse(joined("further_uvs is NULL, but further_uv_count is ", count));
    mesh.furtherUvs.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!source.further_uvs[i]) continue;
        element.numbers(joined("further_uvs[", i, "]").c_str(), source.further_uvs[i], source.vertex_count,
                        mesh.furtherUvs[i]);
    }
}

void takeVertices(const candela_mesh& source, const AbiReader& element, Mesh& mesh) {
    const std::uint32_t count = source.vertex_count;
    element.numbers("position", source.positions, count, mesh.positions);
    const auto takeOptional = [&](const char* member, const float* from, auto& to) {
        if (from) element.numbers(member, from, count, to);
    };
    // These may hold anything: what is no direction is replaced later.
    const auto copyDirections = [&](const float* from, auto& to) {
        if (!from) return;
        copyInBlocks(from, count, to, [](const float*, std::size_t) {});
    };
    copyDirections(source.normals, mesh.normals);
    copyDirections(source.tangents, mesh.tangents);
    takeOptional("uv0", source.uv0, mesh.uv0);
    takeOptional("uv1", source.uv1, mesh.uv1);
    takeFurtherUvs(source, element, mesh);
    takeOptional("color", source.colors, mesh.colors);
}

void checkCounts(const candela_mesh& source, const AbiReader& element) {
    const std::uint32_t count = source.index_count;
    if (count > 0 && !source.indices) element.refuse(joined("indices is NULL, but index_count is ", count));
    if (source.face_sizes) return;
    if (count % 3 != 0 && !source.topologies)
        element.refuse(joined("index_count is ", count, ", but a multiple of 3 was expected"));
    if (source.face_count > 0 && !source.topologies && source.face_count != count / 3)
        element.refuse(joined("face_sizes is NULL, which makes ", count / 3, " triangles, but face_count is ",
                              source.face_count));
}

void takeIndices(const candela_mesh& source, const AbiReader& element, Mesh& mesh) {
    element.present("indices", source.indices, source.index_count);
    const std::uint32_t end = source.vertex_count;
    const std::size_t beyond = copyIndices(source.indices, source.index_count, end, mesh.indices);
    if (beyond < mesh.indices.size())
        element.refuse(
            joined("index ", beyond, " is ", mesh.indices[beyond], ", but there are ", end, " vertices"));
}

/// In a mesh with `topologies` a triangle may begin at any index.
void checkRun(const Submesh& run, const std::string& label, const AbiReader& element,
              const candela_mesh& source) {
    const std::uint32_t corners = cornersOf(run.topology);
    const auto checkMultiple = [&](const char* member, std::uint32_t value) {
        if (value % corners == 0) return;
        element.refuse(
            joined(label, ": ", member, " is ", value, ", but a multiple of ", corners, " was expected"));
    };
    if (!source.topologies) checkMultiple("first_index", run.firstIndex);
    checkMultiple("index_count", run.indexCount);
    const std::uint64_t end = std::uint64_t{run.firstIndex} + run.indexCount;
    if (end > source.index_count)
        element.refuse(
            joined(label, " ends at index ", end, ", but there are ", source.index_count, " indices"));
}

// A mesh without submeshes is drawn as a whole, with the default material.
Submesh wholeMesh(const candela_mesh& source, const std::optional<PolygonFaces>& polygons) {
    const Submesh whole{0, source.index_count, std::nullopt, Topology::triangles};
    return polygons ? polygons->translated(whole, "the mesh") : whole;
}

Topology topologyOf(const candela_mesh& source, std::uint32_t submesh, const std::string& label,
                    const AbiReader& element) {
    if (!source.topologies) return Topology::triangles;
    const std::string member = label + ": topology";
    const std::uint32_t number = element.enumerator(member.c_str(), source.topologies[submesh], 3);
    if (number != CANDELA_TRIANGLES && source.face_sizes)
        element.refuse(member + " is not that of triangles, but the mesh has face_sizes");
    return static_cast<Topology>(number);
}

void takeSubmeshes(const candela_mesh& source, const AbiReader& element, const Scene& scene,
                   const std::optional<PolygonFaces>& polygons, Mesh& mesh) {
    if (source.submesh_count > 0 && !source.submeshes)
        element.refuse(joined("submeshes is NULL, but submesh_count is ", source.submesh_count));
    if (source.submesh_count == 0 && source.index_count % 3 != 0 && !polygons)
        element.refuse(joined("index_count is ", source.index_count, ", but a multiple of 3 was expected"));
    if (source.submesh_count == 0 && source.index_count > 0)
        mesh.submeshes.push_back(wholeMesh(source, polygons));
    for (std::uint32_t i = 0; i < source.submesh_count; ++i) {
        const std::string label = joined("submesh ", i), member = label + ": material";
        candela_submesh from{};
        std::memcpy(&from, source.submeshes + i, sizeof from);
        const Submesh run{from.first_index, from.index_count,
                          element.reference(member.c_str(), from.material, scene.materials.size()),
                          topologyOf(source, i, label, element)};
        if (!polygons) checkRun(run, label, element, source);
        mesh.submeshes.push_back(polygons ? polygons->translated(run, label) : run);
    }
}

void takeVariants(const candela_mesh& source, const AbiReader& element, const Scene& scene, Mesh& mesh) {
    if (source.variant_material_count > 0 && !source.variant_materials)
        element.refuse(joined("variant_materials is NULL, but variant_material_count is ",
                              source.variant_material_count));
    std::set<std::pair<std::uint32_t, std::uint32_t>> known;
    std::set<std::uint32_t> submeshes;
    for (std::uint32_t i = 0; i < source.variant_material_count; ++i) {
        const std::string label = joined("variant material ", i), member = label + ": material";
        candela_variant_material from{};
        std::memcpy(&from, source.variant_materials + i, sizeof from);
        const auto requireBelow = [&](const char* kind, std::uint32_t index, std::size_t count) {
            if (index >= count)
                element.refuse(joined(label, ": ", kind, " is ", index, ", but there are ", count));
        };
        requireBelow("submesh", from.submesh, mesh.submeshes.size());
        requireBelow("variant", from.variant, scene.variants.size());
        if (!known.emplace(from.submesh, from.variant).second)
            element.refuse(joined(label, ": submesh ", from.submesh, " has a material for variant ",
                                  from.variant, " already"));
        if (submeshes.insert(from.submesh).second)
            mesh.variantMaterials.push_back(
                {from.submesh, std::nullopt, mesh.submeshes[from.submesh].material});
        mesh.variantMaterials.push_back(
            {from.submesh, from.variant,
             element.reference(member.c_str(), from.material, scene.materials.size())});
    }
}

}  // namespace

Mesh meshFrom(const candela_mesh& source, const AbiReader& element, const Scene& scene, NoteList& notes) {
    Mesh mesh;
    mesh.name = element.name();
    takeVertices(source, element, mesh);
    if (element.flag("is_moved", source.is_moved)) {
        if (source.influence_count > 0 || source.morph_target_count > 0)
            element.refuse("is_moved is 1, but it has influences or morph targets");
        numberVertices(mesh);
    }
    checkCounts(source, element);
    std::optional<PolygonFaces> polygons;
    if (source.face_sizes) polygons.emplace(source, element);
    takeIndices(source, element, mesh);
    takeSubmeshes(source, element, scene, polygons, mesh);
    takeVariants(source, element, scene, mesh);
    takeInfluences({source.influence_count, source.joints, source.joint_weights}, element,
                   source.vertex_count, mesh);
    takeMorphTargets(
        {source.morph_target_count, source.morph_offsets, source.morph_normals, source.morph_tangents},
        element, source.vertex_count, mesh.morphTargets);
    if (polygons) polygons->triangulateFaces(mesh);
    if (repairNormals(mesh) > 0)
        notes.add(NoteKind::repaired, element.label(),
                  "normals of length 0 or not finite, replaced by that of a face that uses them");
    const float creaseAngle =
        element.within("crease_angle", source.crease_angle, 0.0f, std::numbers::pi_v<float>);
    if (mesh.normals.empty() && !mesh.positions.empty() && creaseAngle > 0.0f) {
        if (!mesh.tangents.empty())
            notes.add(NoteKind::repaired, element.label(), "tangents without normals, not used");
        computeNormals(mesh, creaseAngle);
    }
    if (mesh.normals.empty() && !mesh.tangents.empty()) {
        mesh.tangents.clear();
        notes.add(NoteKind::repaired, element.label(), "tangents without normals, not used");
    }
    if (repairTangents(mesh) > 0)
        notes.add(NoteKind::repaired, element.label(),
                  "tangents of length 0 or not finite, replaced by a direction perpendicular to the normal");
    return mesh;
}

}  // namespace candela
