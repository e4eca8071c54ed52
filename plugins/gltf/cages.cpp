#include "cages.h"

#include <algorithm>

#include "cage_materials.h"
#include "cage_sharpness.h"
#include "cage_source.h"
#include "joined_cage.h"

namespace candela_gltf {
namespace {

std::uint32_t sizeOf(std::size_t size) {
    return static_cast<std::uint32_t>(size);
}

template <typename T>
const T* dataOf(const std::vector<T>& numbers) {
    return numbers.empty() ? nullptr : numbers.data();
}

/// The rows of `numbers`, `width` a vertex of the file, that a cage keeps, added to `kept`.
template <typename T>
void keepRows(const std::vector<T>& numbers, std::size_t width, const JoinedCage& cage,
              std::vector<T>& kept) {
    kept.reserve(kept.size() + cage.vertices.size() * width);
    for (const std::uint32_t vertex : cage.vertices) {
        const auto row = numbers.begin() + static_cast<std::ptrdiff_t>(vertex * width);
        kept.insert(kept.end(), row, row + static_cast<std::ptrdiff_t>(width));
    }
}

void noteLeftOutFaces(const JoinedCage& cage, const std::string& element, const Host& host) {
    const std::size_t leftOut = cage.cageFaces.size() - cage.faceSizes.size();
    if (leftOut == 0) return;
    host.note(element + ": " + std::to_string(leftOut) + (leftOut == 1 ? " face passes" : " faces pass") +
              " twice through a vertex: left out");
}

void requireTriangles(const JoinedCage& cage, const std::string& element) {
    for (std::size_t i = 0; i < cage.cageFaces.size(); ++i) {
        const std::uint32_t face = cage.cageFaces[i];
        if (face == notInCage || cage.faceSizes[face] == 3) continue;
        throw Failure{element, "face " + std::to_string(i) + " has " + std::to_string(cage.faceSizes[face]) +
                                   " corners, but the scheme loop takes triangles only"};
    }
}

candela_cage ruledBy(const CageSettings& settings) {
    candela_cage cage{};
    cage.struct_size = sizeof cage;
    cage.scheme = settings.scheme;
    cage.boundary_interpolation = settings.boundaryInterpolation;
    cage.face_varying_interpolation = settings.faceVaryingInterpolation;
    cage.crease_method = settings.creaseMethod;
    cage.triangle_subdivision = settings.triangleSubdivision;
    cage.level = settings.level;
    return cage;
}

void setTopology(candela_cage& pushed, const JoinedCage& cage) {
    pushed.face_count = sizeOf(cage.faceSizes.size());
    pushed.face_sizes = cage.faceSizes.data();
    pushed.face_vertices = cage.faceVertices.data();
    pushed.uv_count = sizeOf(cage.uvs.size() / 2);
    pushed.uvs = dataOf(cage.uvs);
    pushed.face_uvs = dataOf(cage.faceUvs);
    pushed.face_materials = cage.faceMaterials.data();
}

void setSharpness(candela_cage& pushed, const CageSharpness& sharpness) {
    pushed.crease_count = sizeOf(sharpness.creaseSharpness.size());
    pushed.crease_edges = dataOf(sharpness.creaseEdges);
    pushed.crease_sharpness = dataOf(sharpness.creaseSharpness);
    pushed.corner_count = sizeOf(sharpness.cornerSharpness.size());
    pushed.corner_vertices = dataOf(sharpness.cornerVertices);
    pushed.corner_sharpness = dataOf(sharpness.cornerSharpness);
    pushed.hole_count = sizeOf(sharpness.holes.size());
    pushed.holes = dataOf(sharpness.holes);
}

/// The values of a cage's vertices.
struct VertexValues {
    std::vector<float> positions;
    std::vector<std::uint32_t> joints;
    std::vector<float> jointWeights, morphOffsets;
};

VertexValues valuesOf(const CageVertices& vertices, const JoinedCage& cage) {
    VertexValues values;
    keepRows(vertices.positions, 3, cage, values.positions);
    keepRows(vertices.joints, vertices.influenceCount, cage, values.joints);
    keepRows(vertices.jointWeights, vertices.influenceCount, cage, values.jointWeights);
    for (const std::vector<float>& offsets : vertices.morphOffsets) {
        keepRows(offsets, 3, cage, values.morphOffsets);
    }
    return values;
}

PushedCage pushCage(const Document& document, std::size_t mesh, const std::vector<UvSets>& uvSets,
                    CageMaterials& materials, const Host& host) {
    const CageSettings& settings = document.cages.at(mesh);
    const std::string& name = document.model.meshes.at(mesh).name;
    const std::string element = elementName("mesh", mesh, name);
    const CageSource source = readCageSource(document, mesh, uvSets, host);
    JoinedCage cage = joinCage(source);
    noteLeftOutFaces(cage, element, host);
    if (settings.scheme == CANDELA_SCHEME_LOOP) requireTriangles(cage, element);
    const CageSharpness sharpness =
        resolveSharpness(settings, source, cage, element + ", candela_subdivision");
    if (cage.faceSizes.empty()) {
        host.note(element + ": a cage without a face, which shows nothing");
        return {};
    }

    for (std::int32_t& material : cage.faceMaterials) material = materials.find(material);
    const VertexValues values = valuesOf(source.vertices, cage);
    candela_cage pushed = ruledBy(settings);
    pushed.name = name.c_str();
    setTopology(pushed, cage);
    setSharpness(pushed, sharpness);
    pushed.vertex_count = sizeOf(cage.vertices.size());
    pushed.positions = values.positions.data();
    pushed.influence_count = source.vertices.influenceCount;
    pushed.joints = dataOf(values.joints);
    pushed.joint_weights = dataOf(values.jointWeights);
    pushed.morph_target_count = sizeOf(source.vertices.morphOffsets.size());
    pushed.morph_offsets = dataOf(values.morphOffsets);
    const auto highest = std::max_element(values.joints.begin(), values.joints.end());
    return {host.add(pushed), pushed.influence_count, highest == values.joints.end() ? 0 : *highest + 1,
            pushed.morph_target_count};
}

}  // namespace

const PushedCage* cageOf(const Document& document, std::size_t node, const PushedCages& cages) {
    const int mesh = document.model.nodes.at(node).mesh;
    if (mesh < 0) return nullptr;
    const auto found = cages.find(static_cast<std::size_t>(mesh));
    return found == cages.end() ? nullptr : &found->second;
}

PushedCages pushCages(const Document& document, const std::vector<bool>& used,
                      const PushedMaterials& materials, const Host& host, double from, double to) {
    if (!document.cages.empty() && !host.takesCages()) {
        throw Failure{"candela_subdivision",
                      "the host knows no subdivision cages, for it is older than version 1.1 of plugin.h"};
    }
    CageMaterials cageMaterials(materials, host);
    PushedCages pushed;
    std::size_t done = 0;
    for (const auto& entry : document.cages) {
        const std::size_t mesh = entry.first;
        host.progress(from +
                      (to - from) * static_cast<double>(done++) / static_cast<double>(document.cages.size()));
        if (!used.at(mesh)) continue;
        const PushedCage cage = pushCage(document, mesh, materials.uvSets, cageMaterials, host);
        if (cage.index >= 0) pushed.emplace(mesh, cage);
    }
    return pushed;
}

}  // namespace candela_gltf
