#include "render/draw_list.h"

#include <algorithm>

namespace candela {

namespace {

const Material& materialOf(const Scene& scene, const Submesh& submesh) {
    static const Material none;
    return submesh.material ? scene.materials[*submesh.material] : none;
}

bool isEmissive(const Material& material) {
    return material.unlit || material.emission != glm::vec3(0.0f);
}

bool isPlain(const Material& material, const Mesh& mesh) {
    return !isEmissive(material) && material.alphaMode == AlphaMode::opaque && !material.baseColorTexture &&
           !material.metallicRoughnessTexture && !material.normalTexture && mesh.colors.empty();
}

DrawState stateOf(const Material& material, const Mesh& mesh, GpuImages& images) {
    DrawState state;
    state.doubleSided = material.doubleSided;
    if (isPlain(material, mesh)) return state;
    state.program = DrawState::Program::textured;
    state.emissive = isEmissive(material);
    state.textures = {images.get(material.baseColorTexture, TextureUse::color),
                      images.get(material.metallicRoughnessTexture, TextureUse::data),
                      images.get(material.normalTexture, TextureUse::data),
                      images.get(material.emissionTexture, TextureUse::color)};
    return state;
}

}  // namespace

GpuMeshes::Detail detailOf(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes) {
        for (const Submesh& submesh : mesh.submeshes) {
            if (!isPlain(materialOf(scene, submesh), mesh)) return GpuMeshes::Detail::everything;
        }
    }
    return GpuMeshes::Detail::positionsAndNormals;
}

DrawList::DrawList(const Scene& scene, std::span<const Instance> instances, const GpuMeshes& meshes,
                   GpuImages& images)
    : drawBuffer_("draws"), commandBuffer_("draw commands") {
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const Mesh& mesh = scene.meshes[instances[i].mesh];
        const MeshPlace& place = meshes.places()[instances[i].mesh];
        for (const Submesh& submesh : mesh.submeshes) {
            if (submesh.indexCount == 0) continue;
            const auto material =
                submesh.material.value_or(static_cast<std::uint32_t>(scene.materials.size()));
            draws_.push_back(
                {stateOf(materialOf(scene, submesh), mesh, images),
                 i,
                 material,
                 {submesh.indexCount, 1, place.firstIndex + submesh.firstIndex, place.baseVertex, 0}});
        }
    }
}

void DrawList::setMirrored(const std::vector<bool>& mirrored) {
    for (Draw& draw : draws_) draw.state.mirrored = mirrored[draw.instance];
    std::ranges::stable_sort(draws_, {}, &Draw::state);
    std::vector<std::array<std::uint32_t, 2>> records;
    for (std::uint32_t i = 0; i < draws_.size(); ++i) {
        draws_[i].command.baseInstance = i;
        records.push_back({draws_[i].instance, draws_[i].material});
    }
    drawBuffer_.upload(std::span<const std::array<std::uint32_t, 2>>(records));
}

void DrawList::select(const std::function<bool(std::uint32_t)>& visible) {
    commands_.clear();
    batches_.clear();
    for (const Draw& draw : draws_) {
        if (!visible(draw.instance)) continue;
        if (batches_.empty() || batches_.back().state != draw.state) {
            batches_.push_back({draw.state, static_cast<std::uint32_t>(commands_.size()), 0});
        }
        commands_.push_back(draw.command);
        ++batches_.back().commandCount;
    }
    commandBuffer_.upload(std::span<const Command>(commands_));
}

}  // namespace candela
