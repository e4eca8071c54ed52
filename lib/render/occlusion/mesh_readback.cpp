#include "render/occlusion/mesh_readback.h"

#include "render/layout.h"
#include "scene/model/uv_sets.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <bit>
#include <utility>

namespace candela {

namespace {

/// Does the material let any light through, at some of its points?
bool readsAlpha(const GpuScene::State& scene, const DrawnPart& part) {
    return part.material < scene.sceneState.materials.size() &&
           letsLightThrough(scene.sceneState.materials[part.material]);
}

/// Of the light that meets the surface where it covers all: what passes, of all colours alike.
float transmittedShare(const Material& material) {
    if (!transmits(material)) return 0.0f;
    const glm::vec4& color = material.baseColor;
    return material.transmission.factor * (1.0f - material.metallic) * (color.r + color.g + color.b) / 3.0f;
}

AlphaWrap alphaWrap(Wrap wrap) {
    if (wrap == Wrap::clampToEdge) return AlphaWrap::clampToEdge;
    return wrap == Wrap::mirroredRepeat ? AlphaWrap::mirroredRepeat : AlphaWrap::repeat;
}

/// What is read of an instance.
struct Source {
    const GpuScene::State& scene;
    std::uint32_t instance;
    DrawGeometry geometry;

    const LimitSurface& surface() const { return scene.cages.surface(geometry.index); }
    std::uint32_t mesh() const { return *scene.instances[instance].mesh; }

    std::vector<glm::vec3> positions() const {
        switch (geometry.kind) {
            case DrawGeometry::Kind::cage:
                return surface().readPositions();
            case DrawGeometry::Kind::deformedMesh:
                return scene.meshes.readPositions(
                    mesh(), {scene.deformations.buffers(geometry.index).surface, nullptr});
            default:
                return scene.meshes.readPositions(mesh());
        }
    }
    std::vector<std::uint32_t> indices(const IndexRange& range) const {
        return geometry.kind == DrawGeometry::Kind::cage ? surface().readIndices(range)
                                                         : scene.meshes.readIndices(range);
    }
    std::vector<GpuMeshes::AlphaVertex> alphaVertices(std::size_t count) const {
        if (geometry.kind != DrawGeometry::Kind::cage) return scene.meshes.readAlphaVertices(mesh());
        std::vector<GpuMeshes::AlphaVertex> vertices(count);
        const std::vector<glm::vec2> uvs = surface().readUvs();
        for (std::size_t i = 0; i < uvs.size(); ++i) vertices[i].uv0 = uvs[i];
        return vertices;
    }
};

std::vector<glm::uvec3> trianglesOf(const std::vector<std::uint32_t>& indices) {
    std::vector<glm::uvec3> triangles(indices.size() / 3);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        triangles[i] = {indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]};
    return triangles;
}

/// Makes the cut-outs of one material.
class CutoutMaker {
  public:
    CutoutMaker(const Source& source, std::uint32_t materialIndex, OcclusionMesh& mesh, AlphaImages& images) {
        const GpuScene::State& scene = source.scene;
        const Material& material = scene.sceneState.materials[materialIndex];
        const std::span<const glm::uvec4> record = scene.materials.record(materialIndex);
        const bool isMask = material.alphaMode == AlphaMode::mask;
        const float transmitted = transmittedShare(material);
        if (isMask) triangle_.transmitted = transmitted;
        if (!isMask) factor_ = 1.0f - transmitted;
        if (material.alphaMode != AlphaMode::opaque) factor_ *= material.baseColor.a;
        triangle_.cutoff = std::bit_cast<float>(record[layout::MATERIAL_FACTORS].w);
        triangle_.blends = !isMask;
        usesVertexAlpha_ = material.alphaMode != AlphaMode::opaque;
        for (int row = 0; row < 2; ++row) {
            const glm::uvec4& words = record[static_cast<std::size_t>(layout::MATERIAL_UV_ROWS + row)];
            rows_[row] = {std::bit_cast<float>(words.x), std::bit_cast<float>(words.y),
                          std::bit_cast<float>(words.z)};
        }
        triangle_.image = CutoutTriangle::noImage;
        if (!material.baseColorTexture || material.alphaMode == AlphaMode::opaque) return;
        const Texture& texture = *material.baseColorTexture;
        uvSet_ = texture.uvSet;
        triangle_.wrapS = alphaWrap(texture.wrapS);
        triangle_.wrapT = alphaWrap(texture.wrapT);
        triangle_.nearest = texture.magFilter == Filter::nearest;
        triangle_.image = static_cast<std::uint32_t>(mesh.images.size());
        std::shared_ptr<const AlphaImage>& image = images[texture.image];
        if (!image) image = std::make_shared<AlphaImage>(scene.images.readAlpha(texture.image));
        mesh.images.push_back(image);
        if (uvSet_ >= basicUvSets) furtherUvs_ = scene.meshes.readFurtherUvs(source.mesh(), uvSet_);
    }

    CutoutTriangle make(const glm::uvec3& corners,
                        const std::vector<GpuMeshes::AlphaVertex>& vertices) const {
        CutoutTriangle triangle = triangle_;
        for (int corner = 0; corner < 3; ++corner) {
            const GpuMeshes::AlphaVertex& vertex = vertices[corners[corner]];
            const glm::vec3 uv(uvOf(vertex, corners[corner]), 1.0f);
            triangle.uv[corner] = {glm::dot(rows_[0], uv), glm::dot(rows_[1], uv)};
            triangle.alpha[corner] = usesVertexAlpha_ ? factor_ * vertex.alpha : factor_;
        }
        return triangle;
    }

  private:
    const glm::vec2& uvOf(const GpuMeshes::AlphaVertex& vertex, std::uint32_t index) const {
        if (!furtherUvs_.empty()) return furtherUvs_[index];
        return uvSet_ == 0 ? vertex.uv0 : vertex.uv1;
    }

    CutoutTriangle triangle_;
    glm::vec3 rows_[2];
    float factor_ = 1.0f;
    std::uint32_t uvSet_ = 0;
    std::vector<glm::vec2> furtherUvs_;  ///< Of `uvSet_`, where that is not one of the vertices.
    bool usesVertexAlpha_ = false;
};

}  // namespace

bool hasAlphaPart(const GpuScene::State& scene, std::uint32_t instance) {
    return std::ranges::any_of(scene.draws.partsOf(instance),
                               [&](const DrawnPart& part) { return readsAlpha(scene, part); });
}

OcclusionMesh readOcclusionMesh(const GpuScene::State& scene, std::uint32_t instance, AlphaImages& images) {
    const Source source{scene, instance, scene.draws.geometryOf(instance)};
    OcclusionMesh mesh;
    mesh.positions = source.positions();
    std::vector<DrawnPart> parts = scene.draws.partsOf(instance);
    const auto withAlpha =
        std::ranges::stable_partition(parts, [&](const DrawnPart& part) { return !readsAlpha(scene, part); });
    const std::vector<GpuMeshes::AlphaVertex> vertices = withAlpha.empty()
                                                             ? std::vector<GpuMeshes::AlphaVertex>{}
                                                             : source.alphaVertices(mesh.positions.size());
    for (auto part = parts.begin(); part != parts.end(); ++part) {
        const std::vector<glm::uvec3> triangles = trianglesOf(source.indices(part->indices));
        mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
        if (part < withAlpha.begin()) continue;
        const CutoutMaker maker(source, part->material, mesh, images);
        for (const glm::uvec3& corners : triangles) mesh.cutouts.push_back(maker.make(corners, vertices));
    }
    return mesh;
}

}  // namespace candela
