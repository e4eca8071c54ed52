#include "import/import_refined_cage.h"

#include "import/abi_reader.h"

#include <candela/error.h>

#include <algorithm>
#include <limits>

namespace candela {
namespace {

// A member that messages name: "positions.weights".
std::string memberOf(const char* table, const char* member) {
    return joined(table, ".", member);
}

void takeIndices(const std::uint32_t* from, std::size_t count, std::size_t end, const std::string& member,
                 const char* what, const AbiReader& element, std::vector<std::uint32_t>& out) {
    element.present(member.c_str(), from, count);
    const std::size_t beyond = copyIndices(from, count, end, out);
    if (beyond < count)
        element.refuse(joined(member, " ", beyond, " is ", out[beyond], ", but there are ", end, " ", what));
}

void takeOffsets(const candela_stencil_table& source, const char* name, std::uint32_t vertexCount,
                 const AbiReader& element, StencilTable& table) {
    if (source.stencil_count != vertexCount)
        element.refuse(joined(memberOf(name, "stencil_count"), " is ", source.stencil_count, ", but ",
                              vertexCount, " vertices need a stencil each"));
    const std::string member = memberOf(name, "offsets");
    element.counts(member.c_str(), source.offsets, std::size_t{source.stencil_count} + 1, table.offsets);
    if (table.offsets.front() != 0)
        element.refuse(joined(member, " 0 is ", table.offsets.front(), ", but 0 was expected"));
    const auto falling = std::is_sorted_until(table.offsets.begin(), table.offsets.end());
    if (falling != table.offsets.end())
        element.refuse(joined(member, " ", falling - table.offsets.begin(), " is ", *falling,
                              ", but no less than the one before it, ", *(falling - 1), ", was expected"));
}

StencilTable stencilTableFrom(const candela_stencil_table& source, const char* name,
                              std::uint32_t vertexCount, std::size_t controlCount, const char* controls,
                              const AbiReader& element) {
    StencilTable table;
    takeOffsets(source, name, vertexCount, element, table);
    const std::size_t entries = table.offsets.back();
    takeIndices(source.control_indices, entries, controlCount, memberOf(name, "control_indices"), controls,
                element, table.controlIndices);
    element.numbers(memberOf(name, "weights").c_str(), source.weights, entries, table.weights);
    element.numbers(memberOf(name, "du_weights").c_str(), source.du_weights, entries, table.duWeights);
    element.numbers(memberOf(name, "dv_weights").c_str(), source.dv_weights, entries, table.dvWeights);
    return table;
}

void takeVertices(const candela_refined_cage& source, const AbiReader& element, RefinedCage& refined) {
    if (source.point_count > source.vertex_count)
        element.refuse(joined("point_count is ", source.point_count, ", but there are ", source.vertex_count,
                              " vertices"));
    refined.pointCount = source.point_count;
    takeIndices(source.seam_points, source.vertex_count - source.point_count, source.point_count,
                "seam_points", "points", element, refined.seamPoints);
}

void takeTables(const candela_refined_cage& source, const AbiReader& element, const Cage& cage,
                RefinedCage& refined) {
    refined.positions = stencilTableFrom(source.positions, "positions", source.vertex_count,
                                         cage.positions.size(), "vertices of the cage", element);
    if (!cage.uvs.empty())
        refined.uvs = stencilTableFrom(source.uvs, "uvs", source.vertex_count, cage.uvs.size(),
                                       "texture coordinates of the cage", element);
    else if (source.uvs.stencil_count != 0)
        element.refuse(joined("uvs.stencil_count is ", source.uvs.stencil_count,
                              ", but the cage has no texture coordinates"));
}

void refuseHoles(const RefinedCage& refined, const AbiReader& element, const Cage& cage) {
    std::vector<bool> isHole(cage.faceSizes.size(), false);
    for (const std::uint32_t hole : cage.holes) isHole[hole] = true;
    const auto inHole = std::find_if(refined.cageFaces.begin(), refined.cageFaces.end(),
                                     [&](std::uint32_t face) { return isHole[face]; });
    if (inHole != refined.cageFaces.end())
        element.refuse(joined("cage_faces ", inHole - refined.cageFaces.begin(), " is ", *inHole,
                              ", which is a hole of the cage"));
}

void takeFaces(const candela_refined_cage& source, const AbiReader& element, const Cage& cage,
               RefinedCage& refined) {
    if (source.face_size != 3 && source.face_size != 4)
        element.refuse(joined("face_size is ", source.face_size, ", but 3 or 4 was expected"));
    const std::uint64_t corners = std::uint64_t{source.face_count} * source.face_size;
    if (corners > std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorKind::limit, "",
                    joined(element.label(), ": it has ", corners, " corners, more than 32 bits can count"));
    refined.faceSize = source.face_size;
    takeIndices(source.face_vertices, corners, source.vertex_count, "face_vertices", "vertices", element,
                refined.faceVertices);
    takeIndices(source.cage_faces, source.face_count, cage.faceSizes.size(), "cage_faces",
                "faces of the cage", element, refined.cageFaces);
    if (!cage.holes.empty()) refuseHoles(refined, element, cage);
}

}  // namespace

RefinedCage refinedCageFrom(const candela_refined_cage& source, const AbiReader& element, const Cage& cage) {
    RefinedCage refined;
    takeVertices(source, element, refined);
    takeTables(source, element, cage, refined);
    takeFaces(source, element, cage, refined);
    return refined;
}

}  // namespace candela
