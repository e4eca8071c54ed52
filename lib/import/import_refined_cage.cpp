#include "import/import_refined_cage.h"

#include "import/large_array.h"

#include <candela/error.h>

#include <algorithm>
#include <limits>

namespace candela {
namespace {

// A member that messages name: "positions.weights".
std::string memberOf(const char* rows, const char* member) {
    return joined(rows, ".", member);
}

// Copies indices, which have to be below `end`. The greatest is found without a branch at each: tables have
// many millions of them.
void takeIndices(const std::uint32_t* from, std::size_t count, std::size_t end, const std::string& member,
                 const char* what, const AbiReader& element, std::vector<std::uint32_t>& out) {
    element.present(member.c_str(), from, count);
    std::uint32_t greatest = 0;
    copyInBlocks(from, count, out, [&greatest](const std::uint32_t* block, std::size_t size) {
        for (std::size_t i = 0; i < size; ++i) greatest = std::max(greatest, block[i]);
    });
    if (count == 0 || greatest < end) return;
    const auto beyond =
        std::find_if(out.begin(), out.end(), [end](std::uint32_t index) { return index >= end; });
    element.refuse(
        joined(member, " ", beyond - out.begin(), " is ", *beyond, ", but there are ", end, " ", what));
}

void takeStarts(const candela_stencil_table& delivered, const char* rows, std::uint32_t vertexCount,
                const AbiReader& element, StencilTable& table) {
    if (delivered.row_count != vertexCount)
        element.refuse(joined(memberOf(rows, "row_count"), " is ", delivered.row_count, ", but ", vertexCount,
                              " vertices need a row each"));
    const std::string member = memberOf(rows, "row_starts");
    element.counts(member.c_str(), delivered.row_starts, std::size_t{delivered.row_count} + 1,
                   table.rowStarts);
    if (table.rowStarts.front() != 0)
        element.refuse(joined(member, " 0 is ", table.rowStarts.front(), ", but 0 was expected"));
    const auto falling = std::is_sorted_until(table.rowStarts.begin(), table.rowStarts.end());
    if (falling != table.rowStarts.end())
        element.refuse(joined(member, " ", falling - table.rowStarts.begin(), " is ", *falling,
                              ", but no less than the one before it, ", *(falling - 1), ", was expected"));
}

StencilTable stencilTableFrom(const candela_stencil_table& delivered, const char* rows,
                              std::uint32_t vertexCount, std::size_t columnCount, const char* columns,
                              const AbiReader& element) {
    StencilTable table;
    takeStarts(delivered, rows, vertexCount, element, table);
    const std::size_t entries = table.rowStarts.back();
    takeIndices(delivered.columns, entries, columnCount, memberOf(rows, "columns"), columns, element,
                table.columns);
    element.numbers(memberOf(rows, "weights").c_str(), delivered.weights, entries, table.weights);
    element.numbers(memberOf(rows, "du_weights").c_str(), delivered.du_weights, entries, table.duWeights);
    element.numbers(memberOf(rows, "dv_weights").c_str(), delivered.dv_weights, entries, table.dvWeights);
    return table;
}

void takeVertices(const candela_refined_cage& delivered, const AbiReader& element, RefinedCage& refined) {
    if (delivered.point_count > delivered.vertex_count)
        element.refuse(joined("point_count is ", delivered.point_count, ", but there are ",
                              delivered.vertex_count, " vertices"));
    refined.pointCount = delivered.point_count;
    takeIndices(delivered.seam_points, delivered.vertex_count - delivered.point_count, delivered.point_count,
                "seam_points", "points", element, refined.seamPoints);
}

void takeTables(const candela_refined_cage& delivered, const AbiReader& element, const Cage& cage,
                RefinedCage& refined) {
    refined.positions = stencilTableFrom(delivered.positions, "positions", delivered.vertex_count,
                                         cage.positions.size(), "vertices of the cage", element);
    if (!cage.uvs.empty())
        refined.uvs = stencilTableFrom(delivered.uvs, "uvs", delivered.vertex_count, cage.uvs.size(),
                                       "texture coordinates of the cage", element);
    else if (delivered.uvs.row_count != 0)
        element.refuse(joined("uvs.row_count is ", delivered.uvs.row_count,
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

void takeFaces(const candela_refined_cage& delivered, const AbiReader& element, const Cage& cage,
               RefinedCage& refined) {
    if (delivered.face_size != 3 && delivered.face_size != 4)
        element.refuse(joined("face_size is ", delivered.face_size, ", but 3 or 4 was expected"));
    const std::uint64_t corners = std::uint64_t{delivered.face_count} * delivered.face_size;
    if (corners > std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorKind::limit, "",
                    joined(element.label(), ": it has ", corners, " corners, more than 32 bits can count"));
    refined.faceSize = delivered.face_size;
    takeIndices(delivered.face_vertices, corners, delivered.vertex_count, "face_vertices", "vertices",
                element, refined.faceVertices);
    takeIndices(delivered.cage_faces, delivered.face_count, cage.faceSizes.size(), "cage_faces",
                "faces of the cage", element, refined.cageFaces);
    if (!cage.holes.empty()) refuseHoles(refined, element, cage);
}

}  // namespace

RefinedCage refinedCageFrom(const candela_refined_cage& delivered, const AbiReader& element,
                            const Cage& cage) {
    RefinedCage refined;
    takeVertices(delivered, element, refined);
    takeTables(delivered, element, cage, refined);
    takeFaces(delivered, element, cage, refined);
    return refined;
}

}  // namespace candela
