#include "import/abi_import.h"
#include "import/import_polygons.h"
#include "import/mesh_repair.h"

#include <optional>

namespace candela {
namespace {

void takeVertices(const candela_mesh& pushed, const AbiReader& element, Mesh& mesh) {
    const std::uint32_t count = pushed.vertex_count;
    element.numbers("position", pushed.positions, count, mesh.positions);
    const auto takeOptional = [&](const char* member, const float* from, auto& to) {
        if (from) element.numbers(member, from, count, to);
    };
    takeOptional("normal", pushed.normals, mesh.normals);
    takeOptional("tangent", pushed.tangents, mesh.tangents);
    takeOptional("uv0", pushed.uv0, mesh.uv0);
    takeOptional("uv1", pushed.uv1, mesh.uv1);
    takeOptional("color", pushed.colors, mesh.colors);
}

void checkCounts(const candela_mesh& pushed, const AbiReader& element) {
    const std::uint32_t count = pushed.index_count;
    if (count > 0 && !pushed.indices) element.refuse(joined("indices is NULL, but index_count is ", count));
    if (pushed.face_sizes) return;
    if (count % 3 != 0)
        element.refuse(joined("index_count is ", count, ", but a multiple of 3 was expected"));
    if (pushed.face_count > 0 && pushed.face_count != count / 3)
        element.refuse(joined("face_sizes is NULL, which makes ", count / 3, " triangles, but face_count is ",
                              pushed.face_count));
}

void takeIndices(const candela_mesh& pushed, const AbiReader& element, Mesh& mesh) {
    element.counts("indices", pushed.indices, pushed.index_count, mesh.indices);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        if (mesh.indices[i] >= pushed.vertex_count)
            element.refuse(joined("index ", i, " is ", mesh.indices[i], ", but there are ",
                                  pushed.vertex_count, " vertices"));
}

void checkRun(const Submesh& run, const std::string& label, const AbiReader& element,
              std::uint32_t indexCount) {
    const auto checkMultiple = [&](const char* member, std::uint32_t value) {
        if (value % 3 != 0)
            element.refuse(joined(label, ": ", member, " is ", value, ", but a multiple of 3 was expected"));
    };
    checkMultiple("first_index", run.firstIndex);
    checkMultiple("index_count", run.indexCount);
    const std::uint64_t end = std::uint64_t{run.firstIndex} + run.indexCount;
    if (end > indexCount)
        element.refuse(joined(label, " ends at index ", end, ", but there are ", indexCount, " indices"));
}

void takeSubmeshes(const candela_mesh& pushed, const AbiReader& element, const Scene& scene,
                   const std::optional<PushedPolygons>& polygons, Mesh& mesh) {
    if (pushed.submesh_count > 0 && !pushed.submeshes)
        element.refuse(joined("submeshes is NULL, but submesh_count is ", pushed.submesh_count));
    if (pushed.submesh_count == 0 && pushed.index_count > 0)
        element.refuse(joined("no submesh draws its ", pushed.index_count, " indices"));
    for (std::uint32_t i = 0; i < pushed.submesh_count; ++i) {
        const std::string label = joined("submesh ", i), member = label + ": material";
        candela_submesh from{};
        std::memcpy(&from, pushed.submeshes + i, sizeof from);
        const Submesh run{from.first_index, from.index_count,
                          element.reference(member.c_str(), from.material, scene.materials.size())};
        if (!polygons) checkRun(run, label, element, pushed.index_count);
        mesh.submeshes.push_back(polygons ? polygons->translated(run, label) : run);
    }
}

}  // namespace

Mesh meshFrom(const candela_mesh& pushed, const AbiReader& element, const Scene& scene,
              const NoteSink& note) {
    Mesh mesh;
    mesh.name = element.name();
    takeVertices(pushed, element, mesh);
    checkCounts(pushed, element);
    std::optional<PushedPolygons> polygons;
    if (pushed.face_sizes) polygons.emplace(pushed, element);
    takeIndices(pushed, element, mesh);
    takeSubmeshes(pushed, element, scene, polygons, mesh);
    if (polygons) polygons->cut(mesh);
    const auto noteCount = [&](std::size_t count, const char* text) {
        if (count > 0) note(joined(element.label(), ": ", count, text));
    };
    noteCount(repairNormals(mesh),
              " normals of length 0 were replaced by the normal of a face that uses them");
    if (mesh.normals.empty() && !mesh.tangents.empty()) {
        mesh.tangents.clear();
        note(element.label() + ": its tangents are not used, for it has no normals");
    }
    noteCount(repairTangents(mesh), " tangents of length 0 were replaced by one perpendicular to the normal");
    return mesh;
}

}  // namespace candela
