#include "import/mesh_repair.h"
#include "import/pushed_elements.h"

namespace candela {
namespace {

void takeVertices(const candela_mesh& pushed, const PushedElement& element, Mesh& mesh) {
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

void takeIndices(const candela_mesh& pushed, const PushedElement& element, Mesh& mesh) {
    const std::uint32_t count = pushed.index_count;
    if (count % 3 != 0)
        element.refuse(joined("index_count is ", count, ", but a multiple of 3 was expected"));
    if (count == 0) return;
    if (!pushed.indices) element.refuse(joined("indices is NULL, but index_count is ", count));
    mesh.indices.resize(count);
    std::memcpy(mesh.indices.data(), pushed.indices, count * sizeof(std::uint32_t));
    for (std::uint32_t i = 0; i < count; ++i)
        if (mesh.indices[i] >= pushed.vertex_count)
            element.refuse(joined("index ", i, " is ", mesh.indices[i], ", but there are ",
                                  pushed.vertex_count, " vertices"));
}

void checkRun(const candela_submesh& pushed, std::uint32_t index, const PushedElement& element,
              const Mesh& mesh) {
    const auto checkMultiple = [&](const char* member, std::uint32_t value) {
        if (value % 3 != 0)
            element.refuse(
                joined("submesh ", index, ": ", member, " is ", value, ", but a multiple of 3 was expected"));
    };
    checkMultiple("first_index", pushed.first_index);
    checkMultiple("index_count", pushed.index_count);
    const std::uint64_t end = std::uint64_t{pushed.first_index} + pushed.index_count;
    if (end > mesh.indices.size())
        element.refuse(joined("submesh ", index, " ends at index ", end, ", but there are ",
                              mesh.indices.size(), " indices"));
}

void takeSubmeshes(const candela_mesh& pushed, const PushedElement& element, const Scene& scene, Mesh& mesh) {
    if (pushed.submesh_count > 0 && !pushed.submeshes)
        element.refuse(joined("submeshes is NULL, but submesh_count is ", pushed.submesh_count));
    if (pushed.submesh_count == 0 && !mesh.indices.empty())
        element.refuse(joined("no submesh draws its ", mesh.indices.size(), " indices"));
    for (std::uint32_t i = 0; i < pushed.submesh_count; ++i) {
        candela_submesh run{};
        std::memcpy(&run, pushed.submeshes + i, sizeof run);
        checkRun(run, i, element, mesh);
        const std::string member = joined("submesh ", i, ": material");
        mesh.submeshes.push_back({run.first_index, run.index_count,
                                  element.reference(member.c_str(), run.material, scene.materials.size())});
    }
}

}  // namespace

Mesh meshFrom(const candela_mesh& pushed, const PushedElement& element, const Scene& scene,
              const NoteSink& note) {
    Mesh mesh;
    mesh.name = element.name();
    takeVertices(pushed, element, mesh);
    takeIndices(pushed, element, mesh);
    takeSubmeshes(pushed, element, scene, mesh);
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
