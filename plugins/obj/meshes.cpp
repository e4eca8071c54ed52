#include <algorithm>
#include <array>

#include "indexing.h"
#include "normals.h"
#include "parts.h"
#include "statement.h"

namespace candela_plugins::obj {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(float) && sizeof(Vec2) == 2 * sizeof(float));

template <class T>
const float* floats(const std::vector<T>& values) {
    return values.empty() ? nullptr : reinterpret_cast<const float*>(values.data());
}

/// The arrays of a mesh.
class MeshBuilder {
  public:
    MeshBuilder(const Document& document, const Part& part, const std::vector<AddedMaterial>& materials)
        : document_(document), part_(part), materials_(materials) {
        for (const std::uint32_t face : part.faces)
            hasUvs_ |= corners(face)[0].uv != none || materialOf(document, materials, face).readsUvs;
        for (const std::uint32_t face : facesByMaterial()) addFace(face);
        takeVertices();
    }

    std::int32_t add(const Host& host) const {
        candela_mesh mesh{};
        mesh.struct_size = sizeof mesh;
        mesh.name = part_.name.c_str();
        mesh.vertex_count = static_cast<std::uint32_t>(positions_.size());
        mesh.positions = floats(positions_);
        mesh.normals = floats(normals_);
        mesh.uv0 = floats(uvs_);
        mesh.colors = floats(colors_);
        mesh.index_count = static_cast<std::uint32_t>(indices_.size());
        mesh.indices = indices_.data();
        mesh.submesh_count = static_cast<std::uint32_t>(submeshes_.size());
        mesh.submeshes = submeshes_.data();
        mesh.face_count = static_cast<std::uint32_t>(faceSizes_.size());
        mesh.face_sizes = faceSizes_.data();
        return host.add(mesh);
    }

    /// Corners without texture coordinates of faces with a texture.
    std::size_t cornersWithoutUv() const { return cornersWithoutUv_; }

  private:
    const Corner* corners(std::uint32_t face) const {
        return &document_.corners[document_.faces[face].firstCorner];
    }

    std::int32_t materialIndex(std::uint32_t face) const {
        return materialOf(document_, materials_, face).index;
    }

    std::vector<std::uint32_t> facesByMaterial() const {
        std::vector<std::uint32_t> faces = part_.faces;
        std::stable_sort(faces.begin(), faces.end(), [&](std::uint32_t a, std::uint32_t b) {
            return materialIndex(a) < materialIndex(b);
        });
        return faces;
    }

    void addFace(std::uint32_t face) {
        const std::int32_t material = materialIndex(face);
        const auto firstIndex = static_cast<std::uint32_t>(indices_.size());
        if (submeshes_.empty() || submeshes_.back().material != material)
            submeshes_.push_back({firstIndex, 0, material});
        const std::uint32_t count = document_.cornerCount(face);
        const std::uint32_t flatNormal = flatNormalOf(face);
        const bool needsUvs = materialOf(document_, materials_, face).readsUvs;
        for (std::uint32_t i = 0; i < count; ++i) {
            const Corner& corner = corners(face)[i];
            if (corner.uv == none && needsUvs) ++cornersWithoutUv_;
            const std::uint32_t normal = corner.normal == none ? flatNormal : corner.normal;
            indices_.push_back(vertices_.indexOf({corner.vertex, corner.uv, normal}));
        }
        submeshes_.back().index_count += count;
        faceSizes_.push_back(count);
    }

    /// The index of a face's own normal behind those of the document; none where its corners have normals.
    std::uint32_t flatNormalOf(std::uint32_t face) {
        if (corners(face)[0].normal != none) return none;
        flatNormals_.push_back(faceNormal(document_, face));
        return static_cast<std::uint32_t>(document_.normals.size() + flatNormals_.size() - 1);
    }

    void takeVertices() {
        const std::size_t given = document_.normals.size();
        for (const auto& [vertex, uv, normal] : vertices_.keys()) {
            positions_.push_back(document_.positions[vertex]);
            normals_.push_back(normal < given ? document_.normals[normal] : flatNormals_[normal - given]);
            if (hasUvs_) uvs_.push_back(uv == none ? Vec2{} : document_.uvs[uv]);
            if (document_.colors.empty()) continue;
            const Vec3& color = document_.colors[vertex];
            colors_.push_back({color.x, color.y, color.z, 1.0f});
        }
    }

    const Document& document_;
    const Part& part_;
    const std::vector<AddedMaterial>& materials_;
    bool hasUvs_ = false;
    std::size_t cornersWithoutUv_ = 0;
    KeyIndex vertices_;
    std::vector<std::uint32_t> indices_, faceSizes_;
    std::vector<candela_submesh> submeshes_;
    std::vector<Vec3> positions_, normals_, flatNormals_;
    std::vector<Vec2> uvs_;
    std::vector<std::array<float, 4>> colors_;
};

}  // namespace

void addMeshes(Document& document, const std::vector<AddedMaterial>& materials, const Host& host,
               double from) {
    turnFacesToNormals(document);
    addSmoothNormals(document);
    const std::vector<Part> parts = splitFaces(document, SplitAt::objectsAndGroups);
    std::size_t done = 0, cornersWithoutUv = 0;
    for (const Part& part : parts) {
        addLooseElements(document, part, materials, host);
        if (part.faces.empty()) continue;
        const MeshBuilder builder(document, part, materials);
        addNode(part.name, document.origin, builder.add(host), host);
        cornersWithoutUv += builder.cornersWithoutUv();
        done += part.faces.size();
        const double share = static_cast<double>(done) / static_cast<double>(document.faces.size());
        host.progress(from + (1.0 - from) * share);
    }
    noteMissingUvs(cornersWithoutUv, host);
}

}  // namespace candela_plugins::obj
