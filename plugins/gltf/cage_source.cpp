#include "cage_source.h"

#include <algorithm>
#include <limits>
#include <map>

#include "attributes.h"
#include "influences.h"
#include "morph_targets.h"
#include "topology.h"

namespace candela_gltf {
namespace {

constexpr const char* uvNames[] = {"TEXCOORD_0", "TEXCOORD_1"};
constexpr std::uint64_t maxElements = std::numeric_limits<std::uint32_t>::max();

/// A primitive that is part of the cage.
struct Piece {
    const tinygltf::Primitive& primitive;
    std::string element;
};

/// What the vertices of all pieces have.
struct Layout {
    const char* uvs = nullptr;  ///< The attribute; none where no piece has it and no material reads it.
    std::uint32_t influenceSets = 0;
    std::size_t morphTargets = 0;
};

std::vector<Piece> piecesOf(const tinygltf::Mesh& mesh, const std::string& element, const Host& host) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
        const tinygltf::Primitive& primitive = mesh.primitives[i];
        const std::string where = element + ", primitive " + std::to_string(i);
        if (!hasTriangles(primitive.mode)) {
            host.note(where + ": points and lines are no part of a cage: left out");
        } else if (accessorOf(primitive, "POSITION") < 0) {
            host.note(where + ": left out of the cage, for it has no POSITION");
        } else {
            pieces.push_back({primitive, where});
        }
    }
    return pieces;
}

UvSets uvSetsOf(const tinygltf::Primitive& primitive, const std::vector<UvSets>& uvSets) {
    return primitive.material < 0 ? UvSets{} : uvSets.at(static_cast<std::size_t>(primitive.material));
}

/// A cage has one set of texture coordinates: the one that its materials read, else the first.
const char* uvAttribute(const std::vector<Piece>& pieces, const std::vector<UvSets>& uvSets,
                        const std::string& element, const Host& host) {
    UvSets needed{};
    for (const Piece& piece : pieces) {
        const UvSets own = uvSetsOf(piece.primitive, uvSets);
        for (const std::size_t set : {0u, 1u}) needed[set] = needed[set] || own[set];
    }
    if (needed[0] && needed[1]) {
        host.note(
            element +
            ": its materials read TEXCOORD_0 and TEXCOORD_1, but a cage has one set: TEXCOORD_0 for all");
    }
    const std::size_t set = needed[1] && !needed[0] ? 1 : 0;
    bool present = needed[set];
    for (const Piece& piece : pieces) {
        const bool here = accessorOf(piece.primitive, uvNames[set]) >= 0;
        present = present || here;
        if (here || !uvSetsOf(piece.primitive, uvSets)[set]) continue;
        host.note(piece.element + ": has no " + uvNames[set] + ", which material " +
                  std::to_string(piece.primitive.material) + " reads: taken as zeros");
    }
    return present ? uvNames[set] : nullptr;
}

std::uint32_t commonInfluenceSets(const std::vector<Piece>& pieces) {
    std::uint32_t most = 0;
    for (const Piece& piece : pieces) most = std::max(most, influenceSets(piece.primitive, piece.element));
    for (const Piece& piece : pieces) {
        if (most == 0 || accessorOf(piece.primitive, "JOINTS_0") >= 0) continue;
        throw Failure{piece.element, "has no JOINTS_0, which other primitives of the mesh have"};
    }
    return most;
}

std::size_t commonMorphTargets(const std::vector<Piece>& pieces) {
    const std::size_t count = pieces.empty() ? 0 : pieces.front().primitive.targets.size();
    for (const Piece& piece : pieces) {
        const std::size_t own = piece.primitive.targets.size();
        if (own == count) continue;
        throw Failure{piece.element, "has " + std::to_string(own) + " morph targets, expected " +
                                         std::to_string(count) + " as the other primitives have"};
    }
    return count;
}

template <typename T>
void append(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

/// What decides about the vertices of a primitive.
using VertexKey = std::pair<std::map<std::string, int>, std::vector<std::map<std::string, int>>>;

VertexKey vertexKey(const tinygltf::Primitive& primitive) {
    VertexKey key{primitive.attributes, primitive.targets};
    key.first.erase(indicesAttribute);
    return key;
}

class SourceReader {
  public:
    SourceReader(const Document& document, const Layout& layout) : document_(document), layout_(layout) {
        source_.vertices.influenceCount = layout.influenceSets * jointsPerSet;
        source_.vertices.morphOffsets.resize(layout.morphTargets);
    }

    void add(const Piece& piece) {
        const VertexRange range = rangeOf(piece);
        source_.numbers.add(range);
        Polygons faces = facesOf(piece, range);
        if (source_.faces.corners.size() + faces.corners.size() > maxElements) {
            throw Failure{piece.element, "makes more than 4294967295 corners"};
        }
        for (std::uint32_t& corner : faces.corners) corner += range.first;
        append(source_.faces.sizes, faces.sizes);
        append(source_.faces.corners, faces.corners);
        source_.faceMaterials.resize(source_.faces.sizes.size(), piece.primitive.material);
    }

    CageSource take() { return std::move(source_); }

  private:
    VertexRange rangeOf(const Piece& piece) {
        const auto [entry, isNew] = ranges_.try_emplace(vertexKey(piece.primitive));
        if (isNew) entry->second = readVertices(piece);
        return entry->second;
    }

    VertexRange readVertices(const Piece& piece) {
        CageVertices& all = source_.vertices;
        const int positions = accessorOf(piece.primitive, "POSITION");
        const std::size_t count = elementCount(document_, positions);
        if (count > maxElements - all.count) {
            throw Failure{piece.element, "makes more than 4294967295 vertices"};
        }
        append(all.positions,
               readAttribute(document_, positions, "POSITION", positionForm, count, piece.element));
        if (layout_.uvs) append(all.uvs, uvsOf(piece, count));
        const Influences influences =
            readInfluences(document_, piece.primitive, layout_.influenceSets, count, piece.element);
        append(all.joints, influences.joints);
        append(all.jointWeights, influences.weights);
        for (std::size_t target = 0; target < layout_.morphTargets; ++target) {
            append(all.morphOffsets[target],
                   readMorphOffsets(document_, piece.primitive, target, count, piece.element));
        }
        const VertexRange range{all.count, static_cast<std::uint32_t>(count)};
        all.count += range.count;
        return range;
    }

    std::vector<float> uvsOf(const Piece& piece, std::size_t count) const {
        const int accessor = accessorOf(piece.primitive, layout_.uvs);
        if (accessor < 0) return std::vector<float>(count * uvForm.components);
        return readAttribute(document_, accessor, layout_.uvs, uvForm, count, piece.element);
    }

    Polygons facesOf(const Piece& piece, const VertexRange& range) const {
        const tinygltf::Primitive& primitive = piece.primitive;
        std::vector<std::uint32_t> triangles = triangulate(
            primitive.mode, readCorners(document_, primitive, range.count, piece.element), piece.element);
        if (!primitive.extensions.contains("FB_ngon_encoding")) {
            return polygonsOfTriangles(std::move(triangles));
        }
        if (primitive.mode != TINYGLTF_MODE_TRIANGLES) {
            throw Failure{piece.element, "has FB_ngon_encoding and mode " + std::to_string(primitive.mode) +
                                             ", expected mode 4, triangles"};
        }
        return recoverPolygons(triangles, piece.element);
    }

    const Document& document_;
    Layout layout_;
    CageSource source_;
    std::map<VertexKey, VertexRange> ranges_;
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

CageSource readCageSource(const Document& document, std::size_t mesh, const std::vector<UvSets>& uvSets,
                          const Host& host) {
    const tinygltf::Mesh& source = document.model.meshes.at(mesh);
    const std::string element = elementName("mesh", mesh, source.name);
    const std::vector<Piece> pieces = piecesOf(source, element, host);
    const Layout layout{uvAttribute(pieces, uvSets, element, host), commonInfluenceSets(pieces),
                        commonMorphTargets(pieces)};
    SourceReader reader(document, layout);
    for (const Piece& piece : pieces) {
        if (accessorOf(piece.primitive, "COLOR_0") >= 0) {
            host.note(piece.element + ": a cage has no vertex colours: COLOR_0 is left out");
        }
        reader.add(piece);
    }
    return reader.take();
}

}  // namespace candela_gltf
