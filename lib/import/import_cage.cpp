#include "import/abi_import.h"
#include "import/import_deformation.h"

#include <candela/error.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace candela {
namespace {

void takeRules(const candela_cage& source, const AbiReader& element, Cage& cage) {
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
    const auto translated = [&](const char* member, const auto& value, const auto& enumerators) {
        return enumerators[element.enumerator(member, value, static_cast<std::uint32_t>(enumerators.size()))];
    };
    cage.scheme = translated("scheme", source.scheme, schemes);
    cage.boundaryInterpolation =
        translated("boundary_interpolation", source.boundary_interpolation, boundaries);
    cage.faceVaryingInterpolation =
        translated("face_varying_interpolation", source.face_varying_interpolation, faceVaryings);
    cage.creaseMethod = translated("crease_method", source.crease_method, creaseMethods);
    cage.triangleSubdivision = translated("triangle_subdivision", source.triangle_subdivision, triangleRules);
    if (source.level > maxSubdivisionLevel)
        element.refuse(
            joined("level is ", source.level, ", but 0 to ", maxSubdivisionLevel, " was expected"));
    if (source.level > 0) cage.level = source.level;
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
std::uint64_t takeFaceSizes(const candela_cage& source, const AbiReader& element, Cage& cage) {
    element.counts("face_sizes", source.face_sizes, source.face_count, cage.faceSizes);
    std::uint64_t corners = 0;
    for (std::size_t face = 0; face < cage.faceSizes.size(); ++face) {
        const std::uint32_t size = cage.faceSizes[face];
        if (size < 3 || size > source.vertex_count)
            element.refuse(joined("face ", face, " has ", size, " corners, but 3 to ", source.vertex_count,
                                  ", the number of vertices, were expected"));
        corners += size;
    }
    if (corners > std::numeric_limits<std::uint32_t>::max())
        throw Error(
            ErrorKind::limit, "",
            joined(element.label(), ": its faces have ", corners, " corners, more than 32 bits can count"));
    return corners;
}

void takeFaces(const candela_cage& source, const AbiReader& element, Cage& cage) {
    const std::uint64_t corners = takeFaceSizes(source, element, cage);
    element.counts("face_vertices", source.face_vertices, corners, cage.faceVertices);
    checkCorners(cage.faceVertices, source.vertex_count, "vertex", element, cage);
    if (source.uv_count == 0) return;
    element.numbers("uv", source.uvs, source.uv_count, cage.uvs);
    element.counts("face_uvs", source.face_uvs, corners, cage.faceUvs);
    checkCorners(cage.faceUvs, source.uv_count, "uv", element, cage);
}

void checkVertex(std::uint32_t vertex, const char* what, std::size_t index, const AbiReader& element,
                 const Cage& cage) {
    if (vertex >= cage.positions.size())
        element.refuse(
            joined(what, " ", index, " names vertex ", vertex, ", but there are ", cage.positions.size()));
}

void takeCreases(const candela_cage& source, const AbiReader& element, Cage& cage) {
    std::vector<std::uint32_t> ends;
    std::vector<float> sharpness;
    element.counts("crease_edges", source.crease_edges, 2 * std::size_t{source.crease_count}, ends);
    element.numbers("crease_sharpness", source.crease_sharpness, source.crease_count, sharpness);
    for (std::size_t i = 0; i < source.crease_count; ++i) {
        const Crease crease{ends[2 * i], ends[2 * i + 1], sharpness[i]};
        checkVertex(crease.vertex0, "crease", i, element, cage);
        checkVertex(crease.vertex1, "crease", i, element, cage);
        if (crease.sharpness < 0.0f)
            element.refuse(joined("edge ", crease.vertex0, "-", crease.vertex1, ": its sharpness is ",
                                  crease.sharpness, ", but 0 or more was expected"));
        cage.creases.push_back(crease);
    }
}

void takeCorners(const candela_cage& source, const AbiReader& element, Cage& cage) {
    std::vector<std::uint32_t> vertices;
    std::vector<float> sharpness;
    element.counts("corner_vertices", source.corner_vertices, source.corner_count, vertices);
    element.numbers("corner_sharpness", source.corner_sharpness, source.corner_count, sharpness);
    for (std::size_t i = 0; i < source.corner_count; ++i) {
        checkVertex(vertices[i], "corner", i, element, cage);
        if (sharpness[i] < 0.0f)
            element.refuse(joined("vertex ", vertices[i], ": its sharpness is ", sharpness[i],
                                  ", but 0 or more was expected"));
        cage.corners.push_back({vertices[i], sharpness[i]});
    }
}

void takeHoles(const candela_cage& source, const AbiReader& element, Cage& cage) {
    element.counts("holes", source.holes, source.hole_count, cage.holes);
    for (std::size_t i = 0; i < cage.holes.size(); ++i)
        if (cage.holes[i] >= source.face_count)
            element.refuse(
                joined("hole ", i, " is face ", cage.holes[i], ", but there are ", source.face_count));
}

using FaceMaterials = std::vector<std::optional<std::uint32_t>>;

/// `what` precedes the face in messages.
FaceMaterials faceMaterialsFrom(std::span<const std::int32_t> source, const std::string& what,
                                const AbiReader& element, const Scene& scene) {
    FaceMaterials materials(source.size());
    for (std::size_t face = 0; face < source.size(); ++face) {
        const std::int32_t index = source[face];
        // The label is built only for an error: there may be millions of faces.
        if (index < -1 || index >= static_cast<std::int64_t>(scene.materials.size()))
            element.reference(joined(what, "face ", face, ": material").c_str(), index,
                              scene.materials.size());
        if (index >= 0) materials[face] = static_cast<std::uint32_t>(index);
    }
    return materials;
}

void takeMaterials(const candela_cage& source, const AbiReader& element, const Scene& scene, Cage& cage) {
    if (!source.face_materials) return;
    cage.faceMaterials =
        faceMaterialsFrom(std::span(source.face_materials, source.face_count), "", element, scene);
}

void takeVariants(const candela_cage& source, const AbiReader& element, const Scene& scene, Cage& cage) {
    if (source.variant_count == 0) return;
    element.present("variants", source.variants, source.variant_count);
    cage.variants.push_back({std::nullopt, cage.faceMaterials});
    std::set<std::uint32_t> known;
    for (std::uint32_t i = 0; i < source.variant_count; ++i) {
        const candela_cage_variant& from = source.variants[i];
        const std::string label = joined("variants[", i, "]");
        element.below((label + ".variant").c_str(), from.variant,
                      static_cast<std::uint32_t>(scene.variants.size()));
        if (!known.insert(from.variant).second)
            element.refuse(joined(label, ": variant ", from.variant, " has its materials already"));
        element.present((label + ".face_materials").c_str(), from.face_materials, source.face_count);
        cage.variants.push_back(
            {from.variant, faceMaterialsFrom(std::span(from.face_materials, source.face_count), label + ": ",
                                             element, scene)});
    }
}

}  // namespace

Cage cageFrom(const candela_cage& source, const AbiReader& element, const Scene& scene) {
    Cage cage;
    cage.name = element.name();
    takeRules(source, element, cage);
    element.numbers("position", source.positions, source.vertex_count, cage.positions);
    takeFaces(source, element, cage);
    takeCreases(source, element, cage);
    takeCorners(source, element, cage);
    takeHoles(source, element, cage);
    takeMaterials(source, element, scene, cage);
    takeVariants(source, element, scene, cage);
    takeInfluences({source.influence_count, source.joints, source.joint_weights}, element,
                   cage.positions.size(), cage);
    takeMorphTargets({source.morph_target_count, source.morph_offsets}, element, cage.positions.size(),
                     cage.morphTargets);
    if (element.flag("is_moved", source.is_moved) &&
        (source.influence_count > 0 || source.morph_target_count > 0))
        element.refuse("is_moved is 1, but it has influences or morph targets");
    return cage;
}

namespace {

AbiReader cageElement(const Scene& scene, std::uint32_t index) {
    return {"cage", index, scene.cages[index].name.c_str()};
}

}  // namespace

void addCageInstance(const candela_cage_instance& source, Scene& scene) {
    const AbiReader call("add_cage_instance", std::nullopt, nullptr);
    const auto index = call.reference("node", source.node, scene.nodes.size());
    if (!index) call.refuse("node is -1, but a node was expected");
    Node& node = scene.nodes[*index];
    const AbiReader element("node", *index, node.name.c_str());
    const auto cage = element.reference("cage", source.cage, scene.cages.size());
    if (!cage) element.refuse("cage is -1, but a cage was expected");
    if (node.cage)
        element.refuse(joined("it has an instance of ", cageElement(scene, *node.cage).label(),
                              " already, and can not have another"));
    takeDeformation({source.skin, source.morph_weight_count, source.morph_weights},
                    {cageElement(scene, *cage).label(), scene.cages[*cage].morphTargets.size()}, element,
                    scene, node);
    node.cage = cage;
}

}  // namespace candela
