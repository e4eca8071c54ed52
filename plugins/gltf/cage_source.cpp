#include "cage_source.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "deformation.h"
#include "primitives.h"
#include "variants.h"

namespace candela_plugins::gltf {
namespace {

constexpr std::uint64_t maxElements = std::numeric_limits<std::uint32_t>::max();

/// A primitive that is part of the cage.
struct Part {
    const tinygltf::Primitive& primitive;
    std::string element;
};

/// The attributes that the vertices of all parts have.
struct Layout {
    std::string uvs;  ///< The attribute; empty where no part has it and no material reads it.
    std::uint32_t influenceSets = 0;
    std::size_t morphTargets = 0;
};

std::vector<Part> partsOf(const Document& document, const tinygltf::Mesh& mesh, const std::string& element,
                          const Host& host) {
    std::vector<Part> parts;
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
        const tinygltf::Primitive& primitive = mesh.primitives[i];
        const std::string where = element + ", primitive " + std::to_string(i);
        requireUsable(document, where);
        if (!hasTriangles(primitive.mode)) {
            host.note(CANDELA_NOTE_MISSING, where, "points and lines are no part of a cage: left out");
        } else if (accessorOf(primitive, "POSITION") < 0) {
            host.note(CANDELA_NOTE_MISSING, where, "left out of the cage: no POSITION");
        } else {
            parts.push_back({primitive, where});
        }
    }
    return parts;
}

/// The sets of texture coordinates of the file, n of TEXCOORD_n, that the materials of a part read.
std::vector<int> setsOf(const Part& part, const std::vector<UvSlots>& uvSlots) {
    std::vector<int> sets;
    const UvSlots slots = uvSlotsOf(part.primitive, uvSlots);
    for (std::size_t slot = 0; slot < slots.sets.size(); ++slot) {
        if (slots.isRead[slot]) sets.push_back(slots.sets[slot]);
    }
    return sets;
}

/// A cage has one set of texture coordinates: the first one that its materials read, else TEXCOORD_0.
std::string uvAttribute(const std::vector<Part>& parts, const std::vector<UvSlots>& uvSlots,
                        const std::string& element, const Host& host) {
    std::set<int> needed;
    for (const Part& part : parts) {
        const std::vector<int> sets = setsOf(part, uvSlots);
        needed.insert(sets.begin(), sets.end());
    }
    const std::string attribute = "TEXCOORD_" + std::to_string(needed.empty() ? 0 : *needed.begin());
    if (needed.size() > 1) {
        host.note(CANDELA_NOTE_MISSING, element,
                  "its materials read several sets of texture coordinates, but a cage has one: " + attribute +
                      " for all");
    }
    bool present = !needed.empty();
    for (const Part& part : parts) {
        const bool here = accessorOf(part.primitive, attribute) >= 0;
        present = present || here;
        if (here || setsOf(part, uvSlots).empty()) continue;
        host.note(CANDELA_NOTE_REPAIRED, part.element,
                  "no " + attribute + ", which material " + std::to_string(part.primitive.material) +
                      " reads: taken as zeros");
    }
    return present ? attribute : std::string();
}

std::uint32_t commonInfluenceSets(const std::vector<Part>& parts) {
    std::uint32_t max = 0;
    for (const Part& part : parts) max = std::max(max, influenceSets(part.primitive, part.element));
    for (const Part& part : parts) {
        if (max == 0 || accessorOf(part.primitive, "JOINTS_0") >= 0) continue;
        throw Failure{part.element, "has no JOINTS_0, which other primitives of the mesh have"};
    }
    return max;
}

std::size_t commonMorphTargets(const std::vector<Part>& parts) {
    const std::size_t count = parts.empty() ? 0 : parts.front().primitive.targets.size();
    for (const Part& part : parts) {
        const std::size_t own = part.primitive.targets.size();
        if (own == count) continue;
        throw Failure{part.element, "has " + std::to_string(own) + " morph targets, expected " +
                                        std::to_string(count) + " as the other primitives have"};
    }
    return count;
}

template <typename T>
void append(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

class SourceReader {
  public:
    SourceReader(const Document& document, const Layout& layout, const Host& host)
        : document_(document), layout_(layout), host_(host) {
        source_.vertices.influenceCount = layout.influenceSets * jointsPerSet;
        source_.vertices.morphOffsets.resize(layout.morphTargets);
    }

    void add(const Part& part) {
        const VertexRange range = rangeOf(part);
        source_.numbers.add(range);
        Polygons faces = facesOf(part, range);
        if (source_.faces.corners.size() + faces.corners.size() > maxElements) {
            throw Failure{part.element, "makes more than 4294967295 corners"};
        }
        for (std::uint32_t& corner : faces.corners) corner += range.first;
        append(source_.faces.sizes, faces.sizes);
        append(source_.faces.corners, faces.corners);
        addMaterials(part, source_.faces.sizes.size());
    }

    CageSource take() { return std::move(source_); }

  private:
    /// Those of the faces from the last of the parts before to `end`. In a variant that a part does not name,
    /// its faces have the material without one.
    void addMaterials(const Part& part, std::size_t end) {
        const auto variants = readVariantMaterials(document_, part.primitive, part.element, host_);
        for (const VariantMaterial& own : variants) {
            const bool isKnown = std::ranges::any_of(
                source_.variants, [&](const VariantFaces& faces) { return faces.variant == own.variant; });
            if (!isKnown) source_.variants.push_back({own.variant, source_.faceMaterials});
        }
        for (VariantFaces& faces : source_.variants) {
            const auto own = std::ranges::find(variants, faces.variant, &VariantMaterial::variant);
            faces.materials.resize(end, own == variants.end() ? part.primitive.material : own->material);
        }
        source_.faceMaterials.resize(end, part.primitive.material);
    }

    VertexRange rangeOf(const Part& part) {
        const auto [entry, isNew] = ranges_.try_emplace(vertexAccessors(part.primitive));
        if (isNew) entry->second = readVertices(part);
        return entry->second;
    }

    VertexRange readVertices(const Part& part) {
        CageVertices& all = source_.vertices;
        const int positions = accessorOf(part.primitive, "POSITION");
        const std::size_t count = elementCount(document_, positions);
        if (count > maxElements - all.count) {
            throw Failure{part.element, "makes more than 4294967295 vertices"};
        }
        append(all.positions,
               readAttribute(document_, positions, "POSITION", positionForm, count, part.element));
        if (!layout_.uvs.empty()) append(all.uvs, uvsOf(part, count));
        const Influences influences =
            readInfluences(document_, part.primitive, layout_.influenceSets, {count}, part.element, host_);
        append(all.joints, influences.joints);
        append(all.jointWeights, influences.weights);
        for (std::size_t target = 0; target < layout_.morphTargets; ++target) {
            std::vector<float> offsets =
                readMorphOffsets(document_, part.primitive, target, "POSITION", count, part.element);
            offsets.resize(3 * count);
            append(all.morphOffsets[target], offsets);
        }
        const VertexRange range{all.count, static_cast<std::uint32_t>(count)};
        all.count += range.count;
        return range;
    }

    std::vector<float> uvsOf(const Part& part, std::size_t count) const {
        const int accessor = accessorOf(part.primitive, layout_.uvs);
        if (accessor < 0) return std::vector<float>(count * uvForm.components);
        return readAttribute(document_, accessor, layout_.uvs, uvForm, count, part.element);
    }

    std::vector<std::uint32_t> cornersOf(const Part& part, std::uint32_t vertices) const {
        std::vector<std::uint32_t> corners =
            findCorners(document_, part.primitive, vertices, part.element).take();
        requireCornersBelow(vertices, corners, part.element);
        return corners;
    }

    Polygons facesOf(const Part& part, const VertexRange& range) const {
        const tinygltf::Primitive& primitive = part.primitive;
        std::vector<std::uint32_t> triangles =
            triangulate(primitive.mode, cornersOf(part, range.count), part.element);
        if (!primitive.extensions.contains("FB_ngon_encoding")) {
            return polygonsOfTriangles(std::move(triangles));
        }
        if (primitive.mode != TINYGLTF_MODE_TRIANGLES) {
            throw Failure{part.element, "has FB_ngon_encoding and mode " + std::to_string(primitive.mode) +
                                            ", expected mode 4, triangles"};
        }
        return recoverPolygons(triangles, part.element);
    }

    const Document& document_;
    Layout layout_;
    const Host& host_;
    CageSource source_;
    std::map<VertexAccessors, VertexRange> ranges_;
};

}  // namespace

std::uint64_t VertexNumbers::count() const {
    std::uint64_t count = 0;
    for (const VertexRange& range : ranges_) count += range.count;
    return count;
}

std::optional<std::uint32_t> VertexNumbers::find(std::uint32_t number) const {
    for (const VertexRange& range : ranges_) {
        if (number < range.count) return range.first + number;
        number -= range.count;
    }
    return std::nullopt;
}

CageSource readCageSource(const Document& document, std::size_t mesh, const std::vector<UvSlots>& uvSlots,
                          const Host& host) {
    const tinygltf::Mesh& source = document.model.meshes.at(mesh);
    const std::string element = elementName("mesh", mesh, source.name);
    const std::vector<Part> parts = partsOf(document, source, element, host);
    const Layout layout{uvAttribute(parts, uvSlots, element, host), commonInfluenceSets(parts),
                        commonMorphTargets(parts)};
    SourceReader reader(document, layout, host);
    for (const Part& part : parts) {
        if (accessorOf(part.primitive, "COLOR_0") >= 0) {
            host.note(CANDELA_NOTE_MISSING, part.element,
                      "a cage has no vertex colours: COLOR_0 is left out");
        }
        reader.add(part);
    }
    return reader.take();
}

}  // namespace candela_plugins::gltf
