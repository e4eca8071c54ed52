#include "cages.h"

#include <algorithm>
#include <functional>
#include <map>

#include "cage_settings.h"
#include "cage_source.h"
#include "joined_cage.h"
#include "materials.h"

namespace candela_plugins::gltf {
namespace {

/// Creases, sharp vertices and holes, in the indices of a cage.
struct CageSharpness {
    std::vector<std::uint32_t> creaseEdges;  ///< 2 vertices a crease.
    std::vector<float> creaseSharpness;
    std::vector<std::uint32_t> cornerVertices;
    std::vector<float> cornerSharpness;
    std::vector<std::uint32_t> holes;
};

/// The same for both directions of an edge.
std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

std::vector<std::uint64_t> sortedEdges(const JoinedCage& cage) {
    std::vector<std::uint64_t> edges;
    edges.reserve(cage.faceVertices.size());
    std::size_t begin = 0;
    for (const std::uint32_t size : cage.faceSizes) {
        for (std::uint32_t i = 0; i < size; ++i) {
            edges.push_back(edgeKey(cage.faceVertices[begin + i], cage.faceVertices[begin + (i + 1) % size]));
        }
        begin += size;
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

class Resolver {
  public:
    Resolver(const CageSource& source, const JoinedCage& cage, std::string element)
        : source_(source), cage_(cage), element_(std::move(element)) {}

    void addCreases(const std::vector<SharpEdge>& creases) {
        if (creases.empty()) return;
        const std::vector<std::uint64_t> edges = sortedEdges(cage_);
        for (std::size_t i = 0; i < creases.size(); ++i) {
            const SharpEdge& crease = creases[i];
            const std::string where = element_ + ", creases " + std::to_string(i);
            const std::uint32_t a = vertex(crease.vertex0, where), b = vertex(crease.vertex1, where);
            const std::uint64_t edge = edgeKey(a, b);
            if (!std::binary_search(edges.begin(), edges.end(), edge)) {
                throw Failure{where, "there is no edge from vertex " + std::to_string(crease.vertex0) +
                                         " to vertex " + std::to_string(crease.vertex1)};
            }
            if (!isNew(knownEdges_, edge, crease.sharpness, i, where)) continue;
            result_.creaseEdges.insert(result_.creaseEdges.end(), {a, b});
            result_.creaseSharpness.push_back(crease.sharpness);
        }
    }

    void addCorners(const std::vector<SharpVertex>& corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::string where = element_ + ", corners " + std::to_string(i);
            const std::uint32_t at = vertex(corners[i].vertex, where);
            if (!isNew(knownVertices_, at, corners[i].sharpness, i, where)) continue;
            result_.cornerVertices.push_back(at);
            result_.cornerSharpness.push_back(corners[i].sharpness);
        }
    }

    void addHoles(const std::vector<std::uint32_t>& holes) {
        std::vector<bool> known(cage_.faceSizes.size());
        for (std::size_t i = 0; i < holes.size(); ++i) {
            if (holes[i] >= cage_.cageFaces.size()) {
                throw Failure{element_ + ", holes " + std::to_string(i),
                              "face " + std::to_string(holes[i]) + " does not exist: the mesh has " +
                                  std::to_string(cage_.cageFaces.size())};
            }
            const std::uint32_t face = cage_.cageFaces[holes[i]];
            if (face == notInCage || known[face]) continue;
            known[face] = true;
            result_.holes.push_back(face);
        }
    }

    CageSharpness take() { return std::move(result_); }

  private:
    struct Known {
        float sharpness;
        std::size_t entry;
    };
    using KnownValues = std::map<std::uint64_t, Known>;

    std::uint32_t vertex(std::uint32_t number, const std::string& where) const {
        const std::optional<std::uint32_t> found = source_.numbers.find(number);
        if (!found) {
            throw Failure{where, "vertex " + std::to_string(number) + " does not exist: the mesh has " +
                                     std::to_string(source_.numbers.count())};
        }
        const std::uint32_t vertex = cage_.cageVertices[*found];
        if (vertex == notInCage) {
            throw Failure{where, "vertex " + std::to_string(number) + " belongs to no face"};
        }
        return vertex;
    }

    /// The file may name a vertex by each of its split copies: repetition is allowed with the same value.
    static bool isNew(KnownValues& known, std::uint64_t key, float sharpness, std::size_t entry,
                      const std::string& where) {
        const auto [found, added] = known.try_emplace(key, Known{sharpness, entry});
        if (!added && found->second.sharpness != sharpness) {
            throw Failure{where, "gives another sharpness than entry " + std::to_string(found->second.entry) +
                                     " to the same element"};
        }
        return added;
    }

    const CageSource& source_;
    const JoinedCage& cage_;
    std::string element_;
    CageSharpness result_;
    KnownValues knownEdges_, knownVertices_;
};

/// Converts the indices of `settings` from those of the file to those of the cage. Holes among the faces that
/// were left out are dropped. Throws `Failure` for `element` when a vertex, an edge or a face does not exist,
/// and when one edge or vertex gets two values.
CageSharpness resolveSharpness(const CageSettings& settings, const CageSource& source, const JoinedCage& cage,
                               const std::string& element) {
    Resolver resolver(source, cage, element);
    resolver.addCreases(settings.creases);
    resolver.addCorners(settings.corners);
    resolver.addHoles(settings.holes);
    return resolver.take();
}

/// The materials of cages. A cage has one set of texture coordinates, which is set 0 of the host. For a
/// material that reads another set, a copy that reads set 0 is added when a cage first needs it.
class CageMaterials {
  public:
    CageMaterials(AddedMaterials& materials, const Host& host) : materials_(materials), host_(host) {}

    /// The host's index of a material of the file; -1 is the default one.
    std::int32_t find(std::int32_t material);

  private:
    AddedMaterials& materials_;
    const Host& host_;
};

std::int32_t CageMaterials::find(std::int32_t material) {
    if (material < 0) return materials_.defaultMaterial;
    const auto index = static_cast<std::size_t>(material);
    const auto& isRead = materials_.uvSlots.at(index).isRead;
    if (std::none_of(isRead.begin() + 1, isRead.end(), std::identity())) return material;
    const auto [entry, isNew] = materials_.cageCopies.try_emplace(material);
    if (isNew) {
        HostMaterial copy = materials_.added[index];
        copy.setUvSet(0);
        entry->second = copy.add(host_);
    }
    return entry->second;
}

std::uint32_t sizeOf(std::size_t size) {
    return static_cast<std::uint32_t>(size);
}

template <typename T>
const T* dataOf(const std::vector<T>& numbers) {
    return numbers.empty() ? nullptr : numbers.data();
}

/// The rows of `numbers`, `width` a vertex of the file, of the vertices of a cage; appended to `kept`.
template <typename T>
void keepElements(const std::vector<T>& numbers, std::size_t width, const JoinedCage& cage,
                  std::vector<T>& kept) {
    kept.reserve(kept.size() + cage.vertices.size() * width);
    for (const std::uint32_t vertex : cage.vertices) {
        const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(vertex * width);
        kept.insert(kept.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
    }
}

void noteLeftOutFaces(const JoinedCage& cage, const std::string& element, const Host& host) {
    const std::size_t leftOut = cage.cageFaces.size() - cage.faceSizes.size();
    if (leftOut == 0) return;
    host.note(CANDELA_NOTE_MISSING, element,
              std::to_string(leftOut) + (leftOut == 1 ? " face passes" : " faces pass") +
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

candela_cage cageWithRules(const CageSettings& settings) {
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

void setTopology(candela_cage& hostCage, const JoinedCage& cage) {
    hostCage.face_count = sizeOf(cage.faceSizes.size());
    hostCage.face_sizes = cage.faceSizes.data();
    hostCage.face_vertices = cage.faceVertices.data();
    hostCage.uv_count = sizeOf(cage.uvs.size() / 2);
    hostCage.uvs = dataOf(cage.uvs);
    hostCage.face_uvs = dataOf(cage.faceUvs);
    hostCage.face_materials = cage.faceMaterials.data();
}

void setSharpness(candela_cage& hostCage, const CageSharpness& sharpness) {
    hostCage.crease_count = sizeOf(sharpness.creaseSharpness.size());
    hostCage.crease_edges = dataOf(sharpness.creaseEdges);
    hostCage.crease_sharpness = dataOf(sharpness.creaseSharpness);
    hostCage.corner_count = sizeOf(sharpness.cornerSharpness.size());
    hostCage.corner_vertices = dataOf(sharpness.cornerVertices);
    hostCage.corner_sharpness = dataOf(sharpness.cornerSharpness);
    hostCage.hole_count = sizeOf(sharpness.holes.size());
    hostCage.holes = dataOf(sharpness.holes);
}

/// The values of a cage's vertices.
struct VertexValues {
    std::vector<float> positions;
    std::vector<std::uint32_t> joints;
    std::vector<float> jointWeights, morphOffsets;
};

VertexValues valuesOf(const CageVertices& vertices, const JoinedCage& cage) {
    VertexValues values;
    keepElements(vertices.positions, 3, cage, values.positions);
    keepElements(vertices.joints, vertices.influenceCount, cage, values.joints);
    keepElements(vertices.jointWeights, vertices.influenceCount, cage, values.jointWeights);
    for (const std::vector<float>& offsets : vertices.morphOffsets) {
        keepElements(offsets, 3, cage, values.morphOffsets);
    }
    return values;
}

/// The host's materials of the faces that are left, in each variant of the source.
std::vector<VariantFaces> variantsOf(const CageSource& source, const JoinedCage& cage,
                                     CageMaterials& materials) {
    std::vector<VariantFaces> variants;
    for (const VariantFaces& faces : source.variants) {
        VariantFaces& kept = variants.emplace_back(VariantFaces{faces.variant, {}});
        for (std::size_t face = 0; face < cage.cageFaces.size(); ++face) {
            if (cage.cageFaces[face] != notInCage)
                kept.materials.push_back(materials.find(faces.materials[face]));
        }
    }
    return variants;
}

AddedCage addCage(const Document& document, std::size_t mesh, const std::vector<UvSlots>& uvSlots,
                  CageMaterials& materials, const Host& host) {
    const CageSettings& settings = document.cages.at(mesh);
    const std::string& name = document.model.meshes.at(mesh).name;
    const std::string element = elementName("mesh", mesh, name);
    const CageSource source = readCageSource(document, mesh, uvSlots, host);
    JoinedCage cage = joinCage(source);
    noteLeftOutFaces(cage, element, host);
    if (settings.scheme == CANDELA_SCHEME_LOOP) requireTriangles(cage, element);
    const CageSharpness sharpness =
        resolveSharpness(settings, source, cage, element + ", candela_subdivision");
    if (cage.faceSizes.empty()) {
        host.note(CANDELA_NOTE_MISSING, element, "a cage without a face is not drawn");
        return {};
    }

    for (std::int32_t& material : cage.faceMaterials) material = materials.find(material);
    const std::vector<VariantFaces> variants = variantsOf(source, cage, materials);
    std::vector<candela_cage_variant> hostVariants;
    for (const VariantFaces& faces : variants)
        hostVariants.push_back({faces.variant, faces.materials.data()});
    const VertexValues values = valuesOf(source.vertices, cage);
    candela_cage hostCage = cageWithRules(settings);
    hostCage.name = name.c_str();
    setTopology(hostCage, cage);
    setSharpness(hostCage, sharpness);
    hostCage.vertex_count = sizeOf(cage.vertices.size());
    hostCage.positions = values.positions.data();
    hostCage.influence_count = source.vertices.influenceCount;
    hostCage.joints = dataOf(values.joints);
    hostCage.joint_weights = dataOf(values.jointWeights);
    hostCage.morph_target_count = sizeOf(source.vertices.morphOffsets.size());
    hostCage.morph_offsets = dataOf(values.morphOffsets);
    hostCage.variant_count = sizeOf(hostVariants.size());
    hostCage.variants = dataOf(hostVariants);
    const auto highest = std::max_element(values.joints.begin(), values.joints.end());
    return {host.add(hostCage), hostCage.influence_count, highest == values.joints.end() ? 0 : *highest + 1,
            hostCage.morph_target_count};
}

}  // namespace

const AddedCage* cageOf(const Document& document, std::size_t node, const AddedCages& cages) {
    const int mesh = document.model.nodes.at(node).mesh;
    if (mesh < 0) return nullptr;
    const auto found = cages.find(static_cast<std::size_t>(mesh));
    return found == cages.end() ? nullptr : &found->second;
}

AddedCages addCages(Document& document, const std::vector<bool>& used, AddedMaterials& materials,
                    const Host& host, double from, double to) {
    if (!document.cages.empty() && !host.takesCages()) {
        throw Failure{"candela_subdivision",
                      "the host has no subdivision cages: it is older than version 1.1 of plugin.h"};
    }
    CageMaterials cageMaterials(materials, host);
    AddedCages added;
    std::size_t done = 0;
    for (const auto& entry : document.cages) {
        const std::size_t mesh = entry.first;
        host.progress(from +
                      (to - from) * static_cast<double>(done++) / static_cast<double>(document.cages.size()));
        if (!used.at(mesh)) continue;
        AddedCage cage;
        try {
            requireUsable(document, elementName("mesh", mesh, document.model.meshes.at(mesh).name));
            cage = addCage(document, mesh, materials.uvSlots, cageMaterials, host);
        } catch (const Failure& failure) {
            loseGeometry(document, failure, host);
        }
        if (cage.index >= 0) added.emplace(mesh, cage);
    }
    return added;
}

}  // namespace candela_plugins::gltf
