#include "import/abi_import.h"
#include "import/import_cage_deformation.h"

#include <candela/error.h>

#include <array>
#include <limits>

namespace candela {
namespace {

void takeRules(const candela_cage& pushed, const AbiReader& element, Cage& cage) {
    constexpr std::array schemes{SubdivisionScheme::catmullClark, SubdivisionScheme::loop,
                                 SubdivisionScheme::bilinear};
    constexpr std::array boundaries{BoundaryInterpolation::none, BoundaryInterpolation::edges,
                                    BoundaryInterpolation::edgesAndCorners};
    constexpr std::array faceVaryings{
        FaceVaryingInterpolation::none,         FaceVaryingInterpolation::cornersOnly,
        FaceVaryingInterpolation::cornersPlus1, FaceVaryingInterpolation::cornersPlus2,
        FaceVaryingInterpolation::boundaries,   FaceVaryingInterpolation::all};
    constexpr std::array creaseMethods{CreaseMethod::uniform, CreaseMethod::chaikin};
    constexpr std::array triangleRules{TriangleSubdivision::catmullClark, TriangleSubdivision::smooth};
    const auto chosen = [&](const char* member, const auto& value, const auto& choices) {
        return choices[element.enumerator(member, value, static_cast<std::uint32_t>(choices.size()))];
    };
    cage.scheme = chosen("scheme", pushed.scheme, schemes);
    cage.boundaryInterpolation = chosen("boundary_interpolation", pushed.boundary_interpolation, boundaries);
    cage.faceVaryingInterpolation =
        chosen("face_varying_interpolation", pushed.face_varying_interpolation, faceVaryings);
    cage.creaseMethod = chosen("crease_method", pushed.crease_method, creaseMethods);
    cage.triangleSubdivision = chosen("triangle_subdivision", pushed.triangle_subdivision, triangleRules);
    if (pushed.level > maxSubdivisionLevel)
        element.refuse(
            joined("level is ", pushed.level, ", but 0 to ", maxSubdivisionLevel, " was expected"));
    if (pushed.level > 0) cage.level = pushed.level;
}

// Refuses a corner whose index is not below `count`; of several faults the first is named.
void checkCorners(const std::vector<std::uint32_t>& indices, std::uint32_t count, const char* what,
                  const AbiReader& element, const Cage& cage) {
    std::size_t corner = 0;
    for (std::size_t face = 0; face < cage.faceSizes.size(); ++face)
        for (std::uint32_t i = 0; i < cage.faceSizes[face]; ++i, ++corner)
            if (indices[corner] >= count)
                element.refuse(joined("face ", face, ": corner ", i, " has ", what, " ", indices[corner],
                                      ", but there are ", count));
}

// Returns the number of all corners. A face with more corners than there are vertices would pass twice
// through one of them.
std::uint64_t takeFaceSizes(const candela_cage& pushed, const AbiReader& element, Cage& cage) {
    element.counts("face_sizes", pushed.face_sizes, pushed.face_count, cage.faceSizes);
    std::uint64_t corners = 0;
    for (std::size_t face = 0; face < cage.faceSizes.size(); ++face) {
        const std::uint32_t size = cage.faceSizes[face];
        if (size < 3 || size > pushed.vertex_count)
            element.refuse(joined("face ", face, " has ", size, " corners, but 3 to ", pushed.vertex_count,
                                  ", the number of vertices, were expected"));
        corners += size;
    }
    if (corners > std::numeric_limits<std::uint32_t>::max())
        throw Error(
            ErrorKind::limit, "",
            joined(element.label(), ": its faces have ", corners, " corners, more than 32 bits can count"));
    return corners;
}

void takeFaces(const candela_cage& pushed, const AbiReader& element, Cage& cage) {
    const std::uint64_t corners = takeFaceSizes(pushed, element, cage);
    element.counts("face_vertices", pushed.face_vertices, corners, cage.faceVertices);
    checkCorners(cage.faceVertices, pushed.vertex_count, "vertex", element, cage);
    if (pushed.uv_count == 0) return;
    element.numbers("uv", pushed.uvs, pushed.uv_count, cage.uvs);
    element.counts("face_uvs", pushed.face_uvs, corners, cage.faceUvs);
    checkCorners(cage.faceUvs, pushed.uv_count, "uv", element, cage);
}

void checkVertex(std::uint32_t vertex, const char* what, std::size_t index, const AbiReader& element,
                 const Cage& cage) {
    if (vertex >= cage.positions.size())
        element.refuse(
            joined(what, " ", index, " names vertex ", vertex, ", but there are ", cage.positions.size()));
}

void takeCreases(const candela_cage& pushed, const AbiReader& element, Cage& cage) {
    std::vector<std::uint32_t> ends;
    std::vector<float> sharpness;
    element.counts("crease_edges", pushed.crease_edges, 2 * std::size_t{pushed.crease_count}, ends);
    element.numbers("crease_sharpness", pushed.crease_sharpness, pushed.crease_count, sharpness);
    for (std::size_t i = 0; i < pushed.crease_count; ++i) {
        const Crease crease{ends[2 * i], ends[2 * i + 1], sharpness[i]};
        checkVertex(crease.vertex0, "crease", i, element, cage);
        checkVertex(crease.vertex1, "crease", i, element, cage);
        if (crease.sharpness < 0.0f)
            element.refuse(joined("edge ", crease.vertex0, "-", crease.vertex1, ": its sharpness is ",
                                  crease.sharpness, ", but 0 or more was expected"));
        cage.creases.push_back(crease);
    }
}

void takeCorners(const candela_cage& pushed, const AbiReader& element, Cage& cage) {
    std::vector<std::uint32_t> vertices;
    std::vector<float> sharpness;
    element.counts("corner_vertices", pushed.corner_vertices, pushed.corner_count, vertices);
    element.numbers("corner_sharpness", pushed.corner_sharpness, pushed.corner_count, sharpness);
    for (std::size_t i = 0; i < pushed.corner_count; ++i) {
        checkVertex(vertices[i], "corner", i, element, cage);
        if (sharpness[i] < 0.0f)
            element.refuse(joined("vertex ", vertices[i], ": its sharpness is ", sharpness[i],
                                  ", but 0 or more was expected"));
        cage.corners.push_back({vertices[i], sharpness[i]});
    }
}

void takeHoles(const candela_cage& pushed, const AbiReader& element, Cage& cage) {
    element.counts("holes", pushed.holes, pushed.hole_count, cage.holes);
    for (std::size_t i = 0; i < cage.holes.size(); ++i)
        if (cage.holes[i] >= pushed.face_count)
            element.refuse(
                joined("hole ", i, " is face ", cage.holes[i], ", but there are ", pushed.face_count));
}

void takeMaterials(const candela_cage& pushed, const AbiReader& element, const Scene& scene, Cage& cage) {
    if (!pushed.face_materials) return;
    cage.faceMaterials.resize(pushed.face_count);
    for (std::uint32_t face = 0; face < pushed.face_count; ++face) {
        const std::int32_t index = pushed.face_materials[face];
        // Named only where it is at fault: there may be millions of faces.
        if (index < -1 || index >= static_cast<std::int64_t>(scene.materials.size()))
            element.reference(joined("face ", face, ": material").c_str(), index, scene.materials.size());
        if (index >= 0) cage.faceMaterials[face] = static_cast<std::uint32_t>(index);
    }
}

}  // namespace

Cage cageFrom(const candela_cage& pushed, const AbiReader& element, const Scene& scene) {
    Cage cage;
    cage.name = element.name();
    takeRules(pushed, element, cage);
    element.numbers("position", pushed.positions, pushed.vertex_count, cage.positions);
    takeFaces(pushed, element, cage);
    takeCreases(pushed, element, cage);
    takeCorners(pushed, element, cage);
    takeHoles(pushed, element, cage);
    takeMaterials(pushed, element, scene, cage);
    takeInfluences(pushed, element, cage);
    takeMorphTargets(pushed, element, cage);
    return cage;
}

}  // namespace candela
