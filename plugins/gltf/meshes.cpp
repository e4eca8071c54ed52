#include "meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "deformers.h"
#include "elements.h"
#include "primitives.h"
#include "variants.h"
#include "vertex_streams.h"

namespace candela_plugins::gltf {
namespace {

/// The accessors of a primitive: those of its streams, then those of what deforms it.
struct VertexKey {
    Accessors streams;
    std::vector<int> deformers;

    auto operator<=>(const VertexKey&) const = default;
};

/// The vertices that primitives with the same accessors share.
struct VertexRange {
    std::uint32_t first = 0, count = 0;
};

/// The materials of a primitive.
struct Look {
    std::int32_t material;  ///< The host's.
    std::vector<VariantMaterial> variants;
    UvSlots slots;
};

/// Primitives of one mesh that have the same attributes, as one mesh of the host.
class Part {
  public:
    Part(const Deformers& deformers, const Host& host)
        : host_(host), influenceSets_(deformers.influenceSets), targets_(deformers.targets.size()) {}

    /// Throws `Failure` and adds nothing when the primitive cannot be drawn.
    void add(const Document& document, const tinygltf::Primitive& primitive, const Look& look,
             const VertexKey& key, const Deformers& deformers, const std::string& element) {
        const VertexRange range =
            rangeOf(document, key, look.slots, deformers, elementsOf(primitive.mode).name, element);
        Numbers<std::uint32_t> drawn = drawnIndices(document, primitive, range, element);
        const std::size_t first = indices_.size();
        if (first + drawn.size() > std::numeric_limits<std::uint32_t>::max()) {
            throw Failure{element, "makes more than 4294967295 indices"};
        }
        const auto submesh = static_cast<std::uint32_t>(submeshes_.size());
        submeshes_.push_back(
            {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(drawn.size()), look.material});
        if (range.first != 0)
            for (std::uint32_t& corner : drawn.edit()) corner += range.first;
        indices_.append(std::move(drawn));
        for (const VariantMaterial& variant : look.variants)
            variantMaterials_.push_back({submesh, variant.variant, variant.material});
        topologies_.push_back(elementsOf(primitive.mode).topology);
    }

    bool isEmpty() const { return submeshes_.empty(); }

    AddedMesh add(const std::string& name) const {
        candela_mesh mesh{};
        mesh.struct_size = sizeof mesh;
        mesh.name = name.c_str();
        mesh.vertex_count = vertexCount_;
        mesh.positions = dataOf(position);
        mesh.normals = dataOf(normal);
        mesh.tangents = dataOf(tangent);
        mesh.uv0 = dataOf(uv0);
        mesh.uv1 = dataOf(uv0 + 1);
        const std::vector<const float*> furtherUvs = furtherUvData();
        mesh.further_uv_count = static_cast<std::uint32_t>(furtherUvs.size());
        mesh.further_uvs = furtherUvs.data();
        mesh.colors = dataOf(color);
        mesh.index_count = static_cast<std::uint32_t>(indices_.size());
        mesh.indices = indices_.data();
        mesh.submesh_count = static_cast<std::uint32_t>(submeshes_.size());
        mesh.submeshes = submeshes_.data();
        mesh.variant_material_count = static_cast<std::uint32_t>(variantMaterials_.size());
        mesh.variant_materials = variantMaterials_.data();
        const bool hasOnlyTriangles = std::all_of(topologies_.begin(), topologies_.end(), [](auto topology) {
            return topology == CANDELA_TRIANGLES;
        });
        if (!hasOnlyTriangles) mesh.topologies = topologies_.data();
        mesh.influence_count = influenceSets_ * jointsPerSet;
        mesh.joints = influences_.joints.data();
        mesh.joint_weights = influences_.weights.data();
        const std::vector<float> offsets = morphOffsets();
        const std::vector<float> normals = morphVectors(&Deformers::Target::normals, normal);
        const std::vector<float> tangents = morphVectors(&Deformers::Target::tangents, tangent);
        mesh.morph_target_count = targets_.count();
        mesh.morph_offsets = offsets.data();
        mesh.morph_normals = normals.empty() ? nullptr : normals.data();
        mesh.morph_tangents = tangents.empty() ? nullptr : tangents.data();
        return {host_.add(mesh), influenceSets_ > 0, targets_.count()};
    }

  private:
    const float* dataOf(std::size_t stream) const {
        return streams_[stream].empty() ? nullptr : streams_[stream].data();
    }

    /// Of the sets of texture coordinates from 2 on; null for those that the mesh does not have.
    std::vector<const float*> furtherUvData() const {
        std::vector<const float*> sets;
        for (std::size_t s = uv0 + 2; s < streamCount; ++s) sets.push_back(dataOf(s));
        while (!sets.empty() && sets.back() == nullptr) sets.pop_back();
        return sets;
    }

    std::vector<float> morphOffsets() const {
        std::vector<float> offsets = targets_.joined(&Deformers::Target::positions, vertexCount_);
        offsets.resize(std::size_t(targets_.count()) * vertexCount_ * 3);
        return offsets;
    }

    /// Empty where the mesh has nothing of `stream` that could change.
    std::vector<float> morphVectors(std::vector<float> Deformers::Target::*kind, std::size_t stream) const {
        return streams_[stream].empty() ? std::vector<float>() : targets_.joined(kind, vertexCount_);
    }

    /// `name` is that of what uses the vertices, for notes.
    VertexRange rangeOf(const Document& document, const VertexKey& key, const UvSlots& slots,
                        const Deformers& deformers, const char* name, const std::string& element) {
        const Accessors& accessors = key.streams;
        const auto known = ranges_.find(key);
        if (known != ranges_.end()) return known->second;
        const std::size_t count = elementCount(document, accessors[position]);
        if (count > std::numeric_limits<std::uint32_t>::max() - vertexCount_) {
            throw Failure{element, "makes more than 4294967295 vertices"};
        }
        Streams read = readStreams(document, accessors, slots, count, name, element);
        for (std::size_t s = 0; s < streamCount; ++s) streams_[s].append(std::move(read[s]));
        const auto appendAll = [](auto& all, const auto& more) {
            all.insert(all.end(), more.begin(), more.end());
        };
        appendAll(influences_.joints, deformers.influences.joints);
        appendAll(influences_.weights, deformers.influences.weights);
        targets_.add(deformers.targets, vertexCount_, count);
        const VertexRange range{vertexCount_, static_cast<std::uint32_t>(count)};
        vertexCount_ += range.count;
        ranges_.emplace(key, range);
        return range;
    }

    /// Texture coordinates and colours that are not finite become 0 and 1. The host repairs directions.
    Streams readStreams(const Document& document, const Accessors& accessors, const UvSlots& slots,
                        std::size_t count, const char* name, const std::string& element) {
        Streams read;
        for (std::size_t s = 0; s < streamCount; ++s) {
            if (accessors[s] == zeros) read[s] = Numbers(std::vector<float>(count * componentsOf(s)));
            if (accessors[s] < 0) continue;
            read[s] = readStream(document, s, accessors[s], attributeOf(s, slots), count, element);
            if (s == position) noteBrokenVertices(read[s], name, element);
            if (!isUv(s) && s != color) continue;
            if (!replaceNotFinite(read[s], s == color ? 1.0f : 0.0f)) continue;
            host_.note(CANDELA_NOTE_REPAIRED, element + ", attribute " + attributeOf(s, slots),
                       std::string("numbers that are not finite, taken as ") + (s == color ? "1" : "0"));
        }
        return read;
    }

    /// `positions` are those of the vertices that are added next.
    void noteBrokenVertices(Numbers<float>& positions, const char* name, const std::string& element) {
        constexpr float maxCoordinate = 1e9f;  // the host's
        const auto isUsable = [](float coordinate) { return std::abs(coordinate) <= maxCoordinate; };
        if (std::all_of(positions.view().begin(), positions.view().end(), isUsable)) return;
        std::vector<float>& coordinates = positions.edit();
        for (std::size_t i = 0; i < coordinates.size(); ++i) {
            if (isUsable(coordinates[i])) continue;
            coordinates[i] = 0.0f;
            brokenVertices_.insert(vertexCount_ + static_cast<std::uint32_t>(i / 3));
        }
        host_.note(CANDELA_NOTE_MISSING, element,
                   std::string(name) + "s with a vertex that is not finite or beyond 1e9: left out");
    }

    /// The indices of the triangles, lines or points whose vertices exist and are finite.
    Numbers<std::uint32_t> drawnIndices(const Document& document, const tinygltf::Primitive& primitive,
                                        const VertexRange& range, const std::string& element) const {
        const Elements& elements = elementsOf(primitive.mode);
        const std::string name = elements.name;
        Numbers<std::uint32_t> drawn = readElements(document, primitive, range.count, host_, element);
        const auto exists = [&](std::uint32_t vertex) { return vertex < range.count; };
        if (!std::all_of(drawn.view().begin(), drawn.view().end(), exists)) {
            keepElements(drawn.edit(), elements, exists);
            host_.note(CANDELA_NOTE_MISSING, element, name + "s with a vertex that does not exist: left out");
        }
        if (!brokenVertices_.empty()) {
            keepElements(drawn.edit(), elements, [&](std::uint32_t vertex) {
                return !brokenVertices_.contains(range.first + vertex);
            });
        }
        if (!drawn.empty()) return drawn;
        requireCornersBelow(range.count, findCorners(document, primitive, range.count, element).view(),
                            element);
        throw Failure{element + ", attribute POSITION",
                      "no " + name + " has vertices that are finite and within 1e9"};
    }

    const Host& host_;
    Streams streams_;
    std::uint32_t vertexCount_ = 0;
    std::set<std::uint32_t> brokenVertices_;  ///< Of all vertices: those that are not finite.
    Numbers<std::uint32_t> indices_;
    std::vector<candela_submesh> submeshes_;
    std::vector<candela_variant_material> variantMaterials_;
    std::vector<candela_topology> topologies_;  ///< Of the submeshes.
    std::map<VertexKey, VertexRange> ranges_;
    std::uint32_t influenceSets_;
    Influences influences_;
    MorphTargets targets_;
};

/// Which vertex arrays a primitive has, and whether it is triangles: the host gives these normals.
struct Presence {
    bool isTriangles;
    std::array<bool, streamCount> streams;
    std::uint32_t influenceSets;
    std::size_t morphTargets;

    auto operator<=>(const Presence&) const = default;
};

Presence presenceOf(int mode, const Accessors& accessors, const Deformers& deformers) {
    Presence presence{hasTriangles(mode), {}, deformers.influenceSets, deformers.targets.size()};
    std::transform(accessors.begin(), accessors.end(), presence.streams.begin(),
                   [](int a) { return a != absent; });
    return presence;
}

class MeshImporter {
  public:
    MeshImporter(Document& document, const AddedMaterials& materials, const Host& host)
        : document_(document), materials_(materials), host_(host) {}

    std::vector<AddedMesh> add(std::size_t index) {
        const tinygltf::Mesh& mesh = document_.model.meshes[index];
        const std::string element = elementName("mesh", index, mesh.name);
        parts_.clear();
        partOf_.clear();
        deformers_.emplace(document_, index, host_);
        losingGeometry([&] { requireUsable(document_, element); });
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
            const std::string where = element + ", primitive " + std::to_string(i);
            losingGeometry([&] { add(mesh.primitives[i], where); });
        }
        std::vector<AddedMesh> added;
        for (const Part& part : parts_) {
            if (!part.isEmpty()) added.push_back(part.add(mesh.name));
        }
        return added;
    }

    void noteUndrawn() const {
        noteUndrawn(points_, "points");
        noteUndrawn(lines_, "lines");
    }

  private:
    template <typename Action>
    void losingGeometry(const Action& action) {
        try {
            action();
        } catch (const Failure& failure) {
            loseGeometry(document_, failure, host_);
        }
    }

    void add(const tinygltf::Primitive& primitive, const std::string& element) {
        requireUsable(document_, element);
        if (!isDrawn(primitive, element)) return;
        const Look look = lookOf(primitive, element);
        const Accessors accessors = usableAccessors(primitive, look.slots, element);
        noteMissingUvs(accessors, primitive, look.slots, element);
        const VertexKey key{accessors, deformerAccessors(primitive)};
        const Deformers& deformers = deformers_->read(primitive, element);
        const auto [entry, isNew] =
            partOf_.try_emplace(presenceOf(primitive.mode, accessors, deformers), parts_.size());
        if (isNew) parts_.emplace_back(deformers, host_);
        parts_[entry->second].add(document_, primitive, look, key, deformers, element);
    }

    Look lookOf(const tinygltf::Primitive& primitive, const std::string& element) const {
        return {primitive.material < 0 ? materials_.defaultMaterial : primitive.material,
                readVariantMaterials(document_, primitive, element, host_),
                uvSlotsOf(primitive, materials_.uvSlots)};
    }

    /// Attributes other than the position that cannot be read are left out. The position is checked first:
    /// the rest is read for as many vertices as it has.
    Accessors usableAccessors(const tinygltf::Primitive& primitive, const UvSlots& slots,
                              const std::string& element) const {
        Accessors accessors = accessorsOf(primitive, slots);
        const std::size_t vertices = elementCount(document_, accessors[position]);
        checkAttribute(document_, accessors[position], attributeOf(position, {}), positionForm, vertices,
                       element);
        for (std::size_t s = normal; s < streamCount; ++s) {
            if (accessors[s] < 0) continue;
            const bool isLeftOut = host_.leavesOut([&] {
                checkAttribute(document_, accessors[s], attributeOf(s, slots),
                               formOf(document_, s, accessors[s]), vertices, element);
            });
            const bool isRead = isUv(s) && slots.isRead[s - uv0];
            if (isLeftOut) accessors[s] = isRead ? zeros : absent;
        }
        if (accessors[normal] == absent) accessors[tangent] = absent;
        return accessors;
    }

    bool isDrawn(const tinygltf::Primitive& primitive, const std::string& element) {
        if (!hasTriangles(primitive.mode) && !host_.takesLinesAndPoints()) {
            ++(primitive.mode == TINYGLTF_MODE_POINTS ? points_ : lines_);
            return false;
        }
        if (primitive.attributes.contains(attributeOf(position, {}))) return true;
        host_.note(CANDELA_NOTE_MISSING, element, "not drawn: no POSITION");
        return false;
    }

    void noteMissingUvs(const Accessors& accessors, const tinygltf::Primitive& primitive,
                        const UvSlots& slots, const std::string& element) const {
        for (std::size_t stream = uv0; stream < streamCount; ++stream) {
            // One that was left out has a note of its own.
            const std::string attribute = attributeOf(stream, slots);
            if (accessors[stream] != zeros || accessorOf(primitive, attribute) >= 0) continue;
            host_.note(CANDELA_NOTE_REPAIRED, element,
                       "no " + attribute + ", which material " + std::to_string(readerOf(primitive, stream)) +
                           " reads: taken as zeros");
        }
    }

    /// The first material of a primitive that reads a set of texture coordinates, which one does.
    std::size_t readerOf(const tinygltf::Primitive& primitive, std::size_t stream) const {
        for (const std::size_t material : materialsOf(primitive)) {
            if (materials_.uvSlots.at(material).isRead[stream - uv0]) return material;
        }
        return 0;
    }

    void noteUndrawn(std::size_t count, const char* what) const {
        if (count == 0) return;
        host_.note(CANDELA_NOTE_MISSING, "",
                   std::to_string(count) + (count == 1 ? " primitive of " : " primitives of ") + what +
                       (count == 1 ? " is" : " are") +
                       " not drawn: the host is older than version 1.6 of plugin.h");
    }

    Document& document_;
    const AddedMaterials& materials_;
    const Host& host_;
    std::vector<Part> parts_;                  ///< Of the mesh that is being added.
    std::optional<DeformerReader> deformers_;  ///< For it.
    std::map<Presence, std::size_t> partOf_;
    std::size_t points_ = 0, lines_ = 0;
};

}  // namespace

MeshParts addMeshes(Document& document, const std::vector<bool>& used, const AddedMaterials& materials,
                    const Host& host, double from, double to) {
    MeshImporter importer(document, materials, host);
    MeshParts parts(used.size());
    for (std::size_t i = 0; i < used.size(); ++i) {
        host.progress(from + (to - from) * static_cast<double>(i) / static_cast<double>(used.size()));
        if (used[i] && !document.cages.contains(i)) parts[i] = importer.add(i);
    }
    importer.noteUndrawn();
    return parts;
}

}  // namespace candela_plugins::gltf
