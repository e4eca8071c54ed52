#include <algorithm>
#include <array>
#include <cmath>

#include "indexing.h"
#include "parts.h"
#include "statement.h"

namespace candela_plugins::obj {
namespace {

const char* nameOf(const LooseElement& element) {
    return element.topology == CANDELA_LINES ? "lines (l)" : "points (p)";
}

bool isUsable(const Document& document, const Corner& corner) {
    return corner.vertex < document.positions.size() && !std::isnan(document.positions[corner.vertex].x);
}

/// The mesh of the lines and points of a part.
class LooseMesh {
  public:
    LooseMesh(const Document& document, const Part& part, const std::vector<AddedMaterial>& materials)
        : document_(document), materials_(materials) {
        std::vector<std::uint32_t> elements = part.looseElements;
        for (const std::uint32_t element : elements) hasUvs_ |= materialOf(element).readsUvs;
        std::stable_sort(elements.begin(), elements.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return orderOf(a) < orderOf(b); });
        for (const std::uint32_t element : elements) addElement(element);
    }

    /// -1 where there is nothing to draw.
    std::int32_t add(const std::string& name, const Host& host) const {
        if (indices_.empty()) return -1;
        std::vector<Vec3> positions;
        std::vector<Vec2> uvs;
        std::vector<std::array<float, 4>> colors;
        for (const auto& [vertex, uv, unused] : vertices_.keys()) {
            positions.push_back(document_.positions[vertex]);
            if (hasUvs_) uvs.push_back(uv < document_.uvs.size() ? document_.uvs[uv] : Vec2{});
            if (document_.colors.empty()) continue;
            const Vec3& color = document_.colors[vertex];
            colors.push_back({color.x, color.y, color.z, 1.0f});
        }
        candela_mesh mesh{};
        mesh.struct_size = sizeof mesh;
        mesh.name = name.c_str();
        mesh.vertex_count = static_cast<std::uint32_t>(positions.size());
        mesh.positions = &positions[0].x;
        mesh.uv0 = uvs.empty() ? nullptr : &uvs[0].x;
        mesh.colors = colors.empty() ? nullptr : colors[0].data();
        mesh.index_count = static_cast<std::uint32_t>(indices_.size());
        mesh.indices = indices_.data();
        mesh.submesh_count = static_cast<std::uint32_t>(submeshes_.size());
        mesh.submeshes = submeshes_.data();
        mesh.topologies = topologies_.data();
        return host.add(mesh);
    }

  private:
    const LooseElement& at(std::uint32_t element) const { return document_.looseElements[element]; }

    AddedMaterial materialOf(std::uint32_t element) const {
        const std::uint32_t material = document_.states[at(element).state].material;
        return material == none ? materials_.back() : materials_[material];
    }

    std::pair<candela_topology, std::int32_t> orderOf(std::uint32_t element) const {
        return {at(element).topology, materialOf(element).index};
    }

    void addElement(std::uint32_t element) {
        const auto [topology, material] = orderOf(element);
        if (submeshes_.empty() || submeshes_.back().material != material || topologies_.back() != topology) {
            submeshes_.push_back({static_cast<std::uint32_t>(indices_.size()), 0, material});
            topologies_.push_back(topology);
        }
        const Corner* const corners = &document_.looseCorners[at(element).firstCorner];
        const std::uint32_t count = document_.looseCornerCount(element);
        for (std::uint32_t i = 0; i < count; ++i) {
            if (topology == CANDELA_POINTS) addCorner(corners[i]);
            if (topology == CANDELA_LINES && i > 0) addLine(corners[i - 1], corners[i]);
        }
        submeshes_.back().index_count =
            static_cast<std::uint32_t>(indices_.size()) - submeshes_.back().first_index;
    }

    void addLine(const Corner& from, const Corner& to) {
        if (!isUsable(document_, from) || !isUsable(document_, to)) return;
        addCorner(from);
        addCorner(to);
    }

    void addCorner(const Corner& corner) {
        if (!isUsable(document_, corner)) return;
        indices_.push_back(vertices_.indexOf({corner.vertex, hasUvs_ ? corner.uv : none, 0}));
    }

    const Document& document_;
    const std::vector<AddedMaterial>& materials_;
    bool hasUvs_ = false;
    KeyIndex vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<candela_submesh> submeshes_;
    std::vector<candela_topology> topologies_;
};

}  // namespace

void leaveOutLooseElements(Document& document, const Host& host) {
    LineNotes notes;
    for (const LooseElement& element : document.looseElements)
        notes.count(CANDELA_NOTE_MISSING, std::string("not drawn: ") + nameOf(element), element.line);
    notes.add(host, "");
    document.looseElements.clear();
    document.looseCorners.clear();
}

void repairLooseElements(Document& document, const Host& host) {
    LineNotes notes;
    const bool hasNanUvs = std::any_of(document.uvs.begin(), document.uvs.end(),
                                       [](const Vec2& uv) { return std::isnan(uv.x); });
    for (std::uint32_t i = 0; i < document.looseElements.size(); ++i) {
        const LooseElement& element = document.looseElements[i];
        Corner* const corners = document.looseCorners.data() + element.firstCorner;
        const std::uint32_t count = document.looseCornerCount(i);
        if (!std::all_of(corners, corners + count,
                         [&](const Corner& corner) { return isUsable(document, corner); }))
            notes.count(CANDELA_NOTE_MISSING,
                        std::string("left out of ") + nameOf(element) + ": vertices that are not there",
                        element.line);
        if (count < (element.topology == CANDELA_LINES ? 2u : 1u))
            notes.count(CANDELA_NOTE_MISSING,
                        std::string("not drawn: ") + nameOf(element) + " of too few vertices", element.line);
        for (std::uint32_t corner = 0; corner < count; ++corner) {
            std::uint32_t& uv = corners[corner].uv;
            if (uv >= document.uvs.size() || (hasNanUvs && std::isnan(document.uvs[uv].x))) uv = none;
        }
    }
    notes.add(host, "");
}

void addLooseElements(const Document& document, const Part& part, const std::vector<AddedMaterial>& materials,
                      const Host& host) {
    if (part.looseElements.empty()) return;
    const std::int32_t mesh = LooseMesh(document, part, materials).add(part.name, host);
    if (mesh >= 0) addNode(part.name, document.origin, mesh, host);
}

}  // namespace candela_plugins::obj
