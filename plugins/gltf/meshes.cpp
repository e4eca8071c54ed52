#include "meshes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "primitives.h"

namespace candela_plugins::gltf {
namespace {

struct Stream {
    const char* attribute;
    AttributeForm form;
};

enum StreamIndex : std::size_t { position, normal, tangent, uv0, uv1, color, streamCount };

constexpr std::array<Stream, streamCount> streams{{{"POSITION", positionForm},
                                                   {"NORMAL", normalForm},
                                                   {"TANGENT", tangentForm},
                                                   {"TEXCOORD_0", uvForm},
                                                   {"TEXCOORD_1", uvForm},
                                                   {"COLOR_0", {4, fractions, fractions}}}};
constexpr AttributeForm rgbForm{3, fractions, fractions};

/// The accessor of each stream, or one of these where a primitive has none.
using Accessors = std::array<int, streamCount>;
constexpr int absent = -1, zeros = -2;

/// `needed` are the texture coordinates that the primitive's material reads.
Accessors accessorsOf(const tinygltf::Primitive& primitive, const UvSets& needed) {
    Accessors accessors;
    for (std::size_t s = 0; s < streamCount; ++s) {
        accessors[s] = accessorOf(primitive, streams[s].attribute);
    }
    // Tangents without normals are to be ignored (glTF 2.0, 3.7.2.1).
    if (accessors[normal] == absent) accessors[tangent] = absent;
    if (accessors[uv0] == absent && needed[0]) accessors[uv0] = zeros;
    if (accessors[uv1] == absent && needed[1]) accessors[uv1] = zeros;
    return accessors;
}

std::vector<float> withAlpha(const std::vector<float>& rgb) {
    std::vector<float> rgba(rgb.size() / 3 * 4, 1.0f);
    for (std::size_t i = 0; i < rgb.size() / 3; ++i) std::copy_n(&rgb[i * 3], 3, &rgba[i * 4]);
    return rgba;
}

std::vector<float> readStream(const Document& document, std::size_t stream, int accessor,
                              std::size_t vertices, const std::string& element) {
    const Stream& s = streams[stream];
    const bool rgb = stream == color &&
                     componentCount(document.model.accessors.at(static_cast<std::size_t>(accessor))) == 3;
    if (rgb) return withAlpha(readAttribute(document, accessor, s.attribute, rgbForm, vertices, element));
    return readAttribute(document, accessor, s.attribute, s.form, vertices, element);
}

/// The vertices that primitives with the same accessors share.
struct VertexRange {
    std::uint32_t first = 0, count = 0;
};

/// Primitives of one mesh that have the same attributes, as one mesh of the host.
class Part {
  public:
    void add(const Document& document, const tinygltf::Primitive& primitive, const Accessors& accessors,
             const std::string& element) {
        const VertexRange range = rangeOf(document, accessors, element);
        std::vector<std::uint32_t> corners = readCorners(document, primitive, range.count, element);
        const std::vector<std::uint32_t> triangles = triangulate(primitive.mode, std::move(corners), element);
        const std::size_t first = indices_.size();
        if (first + triangles.size() > std::numeric_limits<std::uint32_t>::max()) {
            throw Failure{element, "makes more than 4294967295 indices"};
        }
        for (const std::uint32_t corner : triangles) indices_.push_back(range.first + corner);
        submeshes_.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(triangles.size()),
                              primitive.material});
    }

    std::int32_t add(const std::string& name, const Host& host) const {
        candela_mesh mesh{};
        mesh.struct_size = sizeof mesh;
        mesh.name = name.c_str();
        mesh.vertex_count = vertexCount_;
        mesh.positions = dataOf(position);
        mesh.normals = dataOf(normal);
        mesh.tangents = dataOf(tangent);
        mesh.uv0 = dataOf(uv0);
        mesh.uv1 = dataOf(uv1);
        mesh.colors = dataOf(color);
        mesh.index_count = static_cast<std::uint32_t>(indices_.size());
        mesh.indices = indices_.data();
        mesh.submesh_count = static_cast<std::uint32_t>(submeshes_.size());
        mesh.submeshes = submeshes_.data();
        return host.add(mesh);
    }

  private:
    const float* dataOf(std::size_t stream) const {
        return streams_[stream].empty() ? nullptr : streams_[stream].data();
    }

    VertexRange rangeOf(const Document& document, const Accessors& accessors, const std::string& element) {
        const auto known = ranges_.find(accessors);
        if (known != ranges_.end()) return known->second;
        const std::size_t count = elementCount(document, accessors[position]);
        if (count > std::numeric_limits<std::uint32_t>::max() - vertexCount_) {
            throw Failure{element, "makes more than 4294967295 vertices"};
        }
        for (std::size_t s = 0; s < streamCount; ++s) {
            if (accessors[s] >= 0) append(document, s, accessors[s], count, element);
            if (accessors[s] == zeros) {
                streams_[s].resize(streams_[s].size() + count * streams[s].form.components);
            }
        }
        const VertexRange range{vertexCount_, static_cast<std::uint32_t>(count)};
        vertexCount_ += range.count;
        ranges_.emplace(accessors, range);
        return range;
    }

    void append(const Document& document, std::size_t stream, int accessor, std::size_t vertices,
                const std::string& element) {
        std::vector<float> numbers = readStream(document, stream, accessor, vertices, element);
        std::vector<float>& all = streams_[stream];
        if (all.empty()) {
            all = std::move(numbers);
        } else {
            all.insert(all.end(), numbers.begin(), numbers.end());
        }
    }

    std::array<std::vector<float>, streamCount> streams_;
    std::uint32_t vertexCount_ = 0;
    std::vector<std::uint32_t> indices_;
    std::vector<candela_submesh> submeshes_;
    std::map<Accessors, VertexRange> ranges_;
};

using Presence = std::array<bool, streamCount>;

Presence presenceOf(const Accessors& accessors) {
    Presence presence;
    std::transform(accessors.begin(), accessors.end(), presence.begin(), [](int a) { return a != absent; });
    return presence;
}

class MeshImporter {
  public:
    MeshImporter(const Document& document, const std::vector<UvSets>& uvSets, const Host& host)
        : document_(document), uvSets_(uvSets), host_(host) {}

    std::vector<std::int32_t> add(std::size_t index) {
        const tinygltf::Mesh& mesh = document_.model.meshes[index];
        const std::string element = elementName("mesh", index, mesh.name);
        std::vector<Part> parts;
        std::map<Presence, std::size_t> partOf;
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
            const tinygltf::Primitive& primitive = mesh.primitives[i];
            const std::string where = element + ", primitive " + std::to_string(i);
            if (!isDrawn(primitive, where)) continue;
            const Accessors accessors = accessorsOf(primitive, uvSetsOf(primitive));
            noteMissingUvs(accessors, primitive.material, where);
            const auto [entry, isNew] = partOf.try_emplace(presenceOf(accessors), parts.size());
            if (isNew) parts.emplace_back();
            parts[entry->second].add(document_, primitive, accessors, where);
        }
        std::vector<std::int32_t> indices;
        for (const Part& part : parts) indices.push_back(part.add(mesh.name, host_));
        return indices;
    }

    void noteUndrawn() const {
        noteUndrawn(points_, "points");
        noteUndrawn(lines_, "lines");
    }

  private:
    bool isDrawn(const tinygltf::Primitive& primitive, const std::string& element) {
        if (!hasTriangles(primitive.mode)) {
            ++(primitive.mode == TINYGLTF_MODE_POINTS ? points_ : lines_);
            return false;
        }
        if (primitive.attributes.contains(streams[position].attribute)) return true;
        host_.note(CANDELA_NOTE_MISSING, element, "not drawn: no POSITION");
        return false;
    }

    UvSets uvSetsOf(const tinygltf::Primitive& primitive) const {
        return primitive.material < 0 ? UvSets{} : uvSets_.at(static_cast<std::size_t>(primitive.material));
    }

    void noteMissingUvs(const Accessors& accessors, int material, const std::string& element) const {
        for (const StreamIndex stream : {uv0, uv1}) {
            if (accessors[stream] != zeros) continue;
            host_.note(CANDELA_NOTE_REPAIRED, element,
                       std::string("no ") + streams[stream].attribute + ", which material " +
                           std::to_string(material) + " reads: taken as zeros");
        }
    }

    void noteUndrawn(std::size_t count, const char* what) const {
        if (count == 0) return;
        host_.note(CANDELA_NOTE_MISSING, "",
                   std::to_string(count) + (count == 1 ? " primitive of " : " primitives of ") + what +
                       (count == 1 ? " is" : " are") + " not drawn");
    }

    const Document& document_;
    const std::vector<UvSets>& uvSets_;
    const Host& host_;
    std::size_t points_ = 0, lines_ = 0;
};

}  // namespace

MeshParts addMeshes(const Document& document, const std::vector<bool>& used,
                    const std::vector<UvSets>& uvSets, const Host& host, double from, double to) {
    MeshImporter importer(document, uvSets, host);
    MeshParts parts(used.size());
    for (std::size_t i = 0; i < used.size(); ++i) {
        host.progress(from + (to - from) * static_cast<double>(i) / static_cast<double>(used.size()));
        if (used[i] && !document.cages.contains(i)) parts[i] = importer.add(i);
    }
    importer.noteUndrawn();
    return parts;
}

}  // namespace candela_plugins::gltf
