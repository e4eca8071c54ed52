#include <algorithm>
#include <tuple>

#include "cage_rules.h"
#include "indexing.h"
#include "parts.h"
#include "statement.h"

namespace candela_plugins::obj {
namespace {

/// The arrays of a cage.
class CageBuilder {
  public:
    CageBuilder(const Document& document, const Part& part, const std::vector<AddedMaterial>& materials)
        : document_(document), part_(part), materials_(materials) {
        for (const std::uint32_t face : part.faces) addFace(face);
        for (const auto& key : vertices_.keys()) positions_.push_back(document.positions[key[0]]);
        if (!hasUvs_) return;
        for (const auto& key : uvKeys_.keys()) uvs_.push_back(key[0] == none ? Vec2{} : document.uvs[key[0]]);
    }

    /// `index` is that of the part.
    void applyRules(CageRules& rules, std::uint32_t index) {
        for (std::size_t i = 0; i < part_.faces.size(); ++i) {
            if (!rules.isHole.empty() && rules.isHole[part_.faces[i]])
                holes_.push_back(static_cast<std::uint32_t>(i));
            if (!rules.creases.empty()) findCreases(part_.faces[i], rules, index);
        }
        if (rules.cornerSharpness.empty()) return;
        for (std::size_t i = 0; i < vertices_.keys().size(); ++i) {
            const auto found = rules.cornerSharpness.find(vertices_.keys()[i][0]);
            if (found == rules.cornerSharpness.end()) continue;
            cornerVertices_.push_back(static_cast<std::uint32_t>(i));
            cornerSharpness_.push_back(found->second);
        }
    }

    std::int32_t add(const Query& query, const CageRules& rules, const Host& host) const {
        candela_cage cage{};
        cage.struct_size = sizeof cage;
        cage.name = part_.name.c_str();
        cage.scheme = query.scheme;
        cage.boundary_interpolation = rules.boundary;
        cage.face_varying_interpolation = rules.faceVarying;
        cage.crease_method = rules.creaseMethod;
        cage.triangle_subdivision = rules.triangles;
        cage.vertex_count = static_cast<std::uint32_t>(positions_.size());
        cage.positions = &positions_[0].x;
        cage.face_count = static_cast<std::uint32_t>(faceSizes_.size());
        cage.face_sizes = faceSizes_.data();
        cage.face_vertices = faceVertices_.data();
        cage.uv_count = static_cast<std::uint32_t>(uvs_.size());
        cage.uvs = hasUvs_ ? &uvs_[0].x : nullptr;
        cage.face_uvs = hasUvs_ ? faceUvs_.data() : nullptr;
        cage.crease_count = static_cast<std::uint32_t>(creaseSharpness_.size());
        cage.crease_edges = creaseEdges_.data();
        cage.crease_sharpness = creaseSharpness_.data();
        cage.corner_count = static_cast<std::uint32_t>(cornerVertices_.size());
        cage.corner_vertices = cornerVertices_.data();
        cage.corner_sharpness = cornerSharpness_.data();
        cage.hole_count = static_cast<std::uint32_t>(holes_.size());
        cage.holes = holes_.data();
        cage.face_materials = faceMaterials_.data();
        cage.level = query.level;
        return host.add(cage);
    }

    /// Corners without texture coordinates of faces with a texture.
    std::size_t cornersWithoutUv() const { return cornersWithoutUv_; }

  private:
    const Corner* corners(std::uint32_t face) const {
        return &document_.corners[document_.faces[face].firstCorner];
    }

    void addFace(std::uint32_t face) {
        const std::uint32_t count = document_.cornerCount(face);
        const AddedMaterial material = materialOf(document_, materials_, face);
        for (std::uint32_t i = 0; i < count; ++i) {
            const Corner& corner = corners(face)[i];
            faceVertices_.push_back(vertices_.indexOf({corner.vertex, 0, 0}));
            faceUvs_.push_back(uvKeys_.indexOf({corner.uv, 0, 0}));
            hasUvs_ |= corner.uv != none;
            if (corner.uv == none && material.readsUvs) ++cornersWithoutUv_;
        }
        faceSizes_.push_back(count);
        faceMaterials_.push_back(material.index);
        hasUvs_ |= material.readsUvs;
    }

    void findCreases(std::uint32_t face, CageRules& rules, std::uint32_t index) {
        const std::uint32_t count = document_.cornerCount(face);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t a = corners(face)[i].vertex, b = corners(face)[(i + 1) % count].vertex;
            const auto found = rules.creases.find(edgeKey(a, b));
            // An edge is met once in each of its faces.
            if (found == rules.creases.end() || found->second.lastPart == index) continue;
            found->second.lastPart = index;
            creaseEdges_.push_back(vertices_.indexOf({a, 0, 0}));
            creaseEdges_.push_back(vertices_.indexOf({b, 0, 0}));
            creaseSharpness_.push_back(found->second.sharpness);
        }
    }

    const Document& document_;
    const Part& part_;
    const std::vector<AddedMaterial>& materials_;
    bool hasUvs_ = false;
    std::size_t cornersWithoutUv_ = 0;
    KeyIndex vertices_, uvKeys_;
    std::vector<Vec3> positions_;
    std::vector<Vec2> uvs_;
    std::vector<std::uint32_t> faceSizes_, faceVertices_, faceUvs_, holes_, creaseEdges_, cornerVertices_;
    std::vector<float> creaseSharpness_, cornerSharpness_;
    std::vector<std::int32_t> faceMaterials_;
};

void requireTriangles(const Document& document) {
    for (std::size_t face = 0; face < document.faces.size(); ++face) {
        if (document.cornerCount(face) == 3) continue;
        throw Failure{"line " + std::to_string(document.faces[face].line),
                      "f: " + std::to_string(document.cornerCount(face)) +
                          " corners, but the Loop scheme takes triangles only"};
    }
}

/// Notes the creases that are an edge of no face, in the order of the file: the map has none.
void noteMissingEdges(const CageRules& rules, const Host& host) {
    std::vector<const SharpEdge*> missing;
    for (const auto& [key, crease] : rules.creases)
        if (crease.lastPart == none) missing.push_back(&crease);
    std::sort(missing.begin(), missing.end(), [](const SharpEdge* a, const SharpEdge* b) {
        return std::tuple(a->tag, a->vertex0, a->vertex1) < std::tuple(b->tag, b->vertex0, b->vertex1);
    });
    for (const SharpEdge* crease : missing) {
        const std::string edge = std::to_string(crease->vertex0) + " " + std::to_string(crease->vertex1);
        host.note(CANDELA_NOTE_REPAIRED, crease->tag->place + ", t crease, edge " + edge,
                  "an edge of no face: not used");
    }
}

void noteUnused(const Document& document, std::size_t cornersWithoutUv, const Host& host) {
    if (!document.normals.empty())
        host.note(CANDELA_NOTE_INFORMATION, "", "not used: normals (vn): a subdivision surface has its own");
    if (!document.colors.empty())
        host.note(CANDELA_NOTE_MISSING, "", "not used: colours of vertices: a cage has none");
    noteMissingUvs(cornersWithoutUv, host);
}

void addNodeOf(const std::string& name, const Vec3& origin, std::int32_t cage, const Host& host) {
    candela_cage_instance instance{};
    instance.struct_size = sizeof instance;
    instance.node = addNode(name, origin, -1, host);
    instance.cage = cage;
    instance.skin = -1;
    host.add(instance);
}

}  // namespace

void addCages(const Document& document, const Query& query, const std::vector<AddedMaterial>& materials,
              const Host& host, double from) {
    if (query.scheme == CANDELA_SCHEME_LOOP) requireTriangles(document);
    CageRules rules = readCageRules(document, query.scheme, host);
    const std::vector<Part> parts = splitFaces(document, SplitAt::objects);
    std::size_t done = 0, cornersWithoutUv = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        CageBuilder builder(document, parts[i], materials);
        builder.applyRules(rules, static_cast<std::uint32_t>(i));
        cornersWithoutUv += builder.cornersWithoutUv();
        addNodeOf(parts[i].name, document.origin, builder.add(query, rules, host), host);
        done += parts[i].faces.size();
        const double share = static_cast<double>(done) / static_cast<double>(document.faces.size());
        host.progress(from + (1.0 - from) * share);
    }
    noteMissingEdges(rules, host);
    noteUnused(document, cornersWithoutUv, host);
}

}  // namespace candela_plugins::obj
