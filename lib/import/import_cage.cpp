#include "import/abi_import.h"

#include <candela/error.h>

#include <array>
#include <limits>
#include <span>
#include <utility>

namespace candela {
namespace {

void normalizeWeights(std::span<float> weights, std::size_t vertex, const AbiReader& element) {
    double sum = 0.0;
    for (const float weight : weights) {
        if (weight < 0.0f)
            element.refuse(
                joined("vertex ", vertex, " has the joint weight ", weight, ", but 0 or more was expected"));
        sum += double{weight};
    }
    if (!(sum > 0.0)) element.refuse(joined("vertex ", vertex, " has joint weights that are all 0"));
    for (float& weight : weights) weight = static_cast<float>(double{weight} / sum);
}

// The joints and weights of all vertices; the weights of each vertex are normalised.
void takeInfluences(const candela_cage& source, const AbiReader& element, Cage& cage) {
    const std::size_t each = source.influence_count, vertices = cage.positions.size();
    element.counts("joints", source.joints, each * vertices, cage.joints);
    element.numbers("joint_weight", source.joint_weights, each * vertices, cage.jointWeights);
    cage.influenceCount = source.influence_count;
    if (each == 0) return;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex)
        normalizeWeights(std::span(cage.jointWeights).subspan(vertex * each, each), vertex, element);
}

void takeMorphTargets(const candela_cage& source, const AbiReader& element, Cage& cage) {
    const std::size_t count = source.morph_target_count, vertices = cage.positions.size();
    if (count == 0) return;
    if (vertices == 0)
        element.refuse(joined("morph_target_count is ", count, ", but there are no vertices to move"));
    if (!source.morph_offsets)
        element.refuse(joined("morph_offsets is NULL, but morph_target_count is ", count));
    for (std::size_t target = 0; target < count; ++target) {
        const std::string member = joined("morph target ", target, ": offset");
        cage.morphTargets.emplace_back();
        element.numbers(member.c_str(), source.morph_offsets + target * vertices * 3, vertices,
                        cage.morphTargets.back().offsets);
    }
}

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

void takeMaterials(const candela_cage& source, const AbiReader& element, const Scene& scene, Cage& cage) {
    if (!source.face_materials) return;
    cage.faceMaterials.resize(source.face_count);
    for (std::uint32_t face = 0; face < source.face_count; ++face) {
        const std::int32_t index = source.face_materials[face];
        // The label is built only for an error: there may be millions of faces.
        if (index < -1 || index >= static_cast<std::int64_t>(scene.materials.size()))
            element.reference(joined("face ", face, ": material").c_str(), index, scene.materials.size());
        if (index >= 0) cage.faceMaterials[face] = static_cast<std::uint32_t>(index);
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
    takeInfluences(source, element, cage);
    takeMorphTargets(source, element, cage);
    return cage;
}

namespace {

AbiReader cageElement(const Scene& scene, std::uint32_t index) {
    return {"cage", index, scene.cages[index].name.c_str()};
}

void takeMorphWeights(const candela_cage_instance& source, const AbiReader& node, const Cage& cage,
                      const std::string& cageLabel, CageInstance& instance) {
    if (source.morph_weight_count == 0) return;
    if (source.morph_weight_count != cage.morphTargets.size())
        node.refuse(joined("morph_weight_count is ", source.morph_weight_count, ", but ", cageLabel, " has ",
                           cage.morphTargets.size(), " morph targets"));
    node.numbers("morph_weight", source.morph_weights, source.morph_weight_count, instance.morphWeights);
}

}  // namespace

void addCageInstance(const candela_cage_instance& source, Scene& scene) {
    const AbiReader call("add_cage_instance", std::nullopt, nullptr);
    const auto index = call.reference("node", source.node, scene.nodes.size());
    if (!index) call.refuse("node is -1, but a node was expected");
    Node& node = scene.nodes[*index];
    const AbiReader element("node", *index, node.name.c_str());
    const auto cageIndex = element.reference("cage", source.cage, scene.cages.size());
    if (!cageIndex) element.refuse("cage is -1, but a cage was expected");
    if (node.cage)
        element.refuse(joined("it has an instance of ", cageElement(scene, node.cage->cage).label(),
                              " already, and can not have another"));
    const Cage& cage = scene.cages[*cageIndex];
    const std::string cageLabel = cageElement(scene, *cageIndex).label();
    CageInstance instance;
    instance.cage = *cageIndex;
    instance.skin = element.reference("skin", source.skin, scene.skins.size());
    takeMorphWeights(source, element, cage, cageLabel, instance);
    node.cage = std::move(instance);
}

Skin skinFrom(const candela_skin& source, const AbiReader& element, const Scene& scene) {
    Skin skin;
    skin.name = element.name();
    const std::uint32_t count = source.joint_count;
    if (count == 0) element.refuse("joint_count is 0, but 1 or more was expected");
    if (!source.joints) element.refuse(joined("joints is NULL, but joint_count is ", count));
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::string member = joined("joint ", i);
        const auto node = element.reference(member.c_str(), source.joints[i], scene.nodes.size());
        if (!node) element.refuse(member + " is -1, but a node was expected");
        skin.joints.push_back(*node);
    }
    if (!source.inverse_bind_matrices) {
        skin.inverseBindMatrices.assign(count, glm::mat4(1.0f));
        return skin;
    }
    element.numbers("inverse_bind_matrix", source.inverse_bind_matrices, count, skin.inverseBindMatrices);
    for (std::uint32_t i = 0; i < count; ++i) {
        glm::mat4& matrix = skin.inverseBindMatrices[i];
        matrix = element.affine(joined("inverse_bind_matrix ", i), matrix);
    }
    return skin;
}

}  // namespace candela
