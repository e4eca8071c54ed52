#include "render/gpu_scene/draw_list.h"

#include <algorithm>
#include <tuple>

namespace candela {

namespace {

const Material& materialOf(std::span<const Material> materials, std::uint32_t index) {
    static const Material none;
    return index < materials.size() ? materials[index] : none;
}

bool isEmissive(const Material& material) {
    return material.unlit || material.emission != glm::vec3(0.0f);
}

enum class Colors { none, perVertex };

Colors colorsOf(const Mesh& mesh) {
    return mesh.colors.empty() ? Colors::none : Colors::perVertex;
}

bool isPlain(const Material& material, Colors colors) {
    return !isEmissive(material) && material.alphaMode == AlphaMode::opaque && !material.baseColorTexture &&
           !material.metallicRoughnessTexture && !material.normalTexture && colors == Colors::none;
}

/// Sets what a draw's state has from the material.
void apply(PipelineKey& state, const Material& material, Colors colors, GpuImages& images) {
    state.doubleSided = material.doubleSided;
    state.emissive = false;
    state.program = PipelineKey::Program::plain;
    state.textures = {};
    if (isPlain(material, colors)) return;
    state.program = PipelineKey::Program::textured;
    state.emissive = isEmissive(material);
    state.textures = {images.get(material.baseColorTexture, TextureInfo::color),
                      images.get(material.metallicRoughnessTexture, TextureInfo::data),
                      images.get(material.normalTexture, TextureInfo::data),
                      images.get(material.emissionTexture, TextureInfo::color)};
}

bool needsDetail(const Scene& scene, const Mesh& mesh) {
    if (!scene.images.empty() && !(mesh.uv0.empty() && mesh.uv1.empty())) return true;
    const auto count = static_cast<std::uint32_t>(scene.materials.size());
    return std::ranges::any_of(mesh.submeshes, [&](const Submesh& submesh) {
        return !isPlain(materialOf(scene.materials, submesh.material.value_or(count)), colorsOf(mesh));
    });
}

}  // namespace

GpuMeshes::Detail detailOf(const Scene& scene) {
    const bool needed =
        std::ranges::any_of(scene.meshes, [&](const Mesh& mesh) { return needsDetail(scene, mesh); });
    return needed ? GpuMeshes::Detail::everything : GpuMeshes::Detail::positionsAndNormals;
}

void DrawList::addMesh(std::uint32_t instance, const Mesh& mesh, const MeshPlace& place,
                       std::span<const Material> materials, GpuImages& images) {
    for (const Submesh& submesh : mesh.submeshes) {
        if (submesh.indexCount == 0) continue;
        const auto material = submesh.material.value_or(static_cast<std::uint32_t>(materials.size()));
        add({{},
             0,
             instance,
             material,
             0,
             colorsOf(mesh) == Colors::perVertex,
             {submesh.indexCount, 1, place.firstIndex + submesh.firstIndex, place.baseVertex, 0}},
            materials, images);
    }
}

void DrawList::addCage(std::uint32_t instance, std::uint32_t geometry, std::span<const std::uint32_t> parts,
                       std::span<const Material> materials, GpuImages& images) {
    for (std::uint32_t part = 0; part < parts.size(); ++part) {
        Draw draw{{}, 0, instance, parts[part], part, false, {0, 1, 0, 0, 0}};
        draw.state.geometry = geometry;
        add(draw, materials, images);
    }
}

void DrawList::add(Draw draw, std::span<const Material> materials, GpuImages& images) {
    apply(draw.state, materialOf(materials, draw.material), draw.hasColors ? Colors::perVertex : Colors::none,
          images);
    draw.order = static_cast<std::uint32_t>(draws_.size());
    draws_.push_back(draw);
    sorted_ = false;
}

void DrawList::setMirrored(const std::vector<bool>& mirrored) {
    for (Draw& draw : draws_) draw.state.mirrored = mirrored[draw.instance];
    sorted_ = false;
}

void DrawList::setMaterial(std::uint32_t index, const Material& material, GpuImages& images) {
    for (Draw& draw : draws_) {
        if (draw.material != index) continue;
        PipelineKey state = draw.state;
        apply(state, material, draw.hasColors ? Colors::perVertex : Colors::none, images);
        if (state == draw.state) continue;
        draw.state = state;
        sorted_ = false;
    }
}

void DrawList::setGeometry(std::uint32_t instance, std::uint32_t geometry) {
    for (Draw& draw : draws_) {
        const std::uint32_t last = draw.state.geometry;
        if (draw.instance != instance || last == 0 || last == geometry) continue;
        draw.state.geometry = geometry;
        draw.command.count = 0;
        sorted_ = false;
    }
}

void DrawList::setRanges(std::uint32_t geometry, std::span<const IndexRange> ranges) {
    for (Draw& draw : draws_) {
        if (draw.state.geometry != geometry) continue;
        draw.command.firstIndex = ranges[draw.part].first;
        draw.command.count = ranges[draw.part].count;
    }
}

void DrawList::sort() {
    if (sorted_) return;
    sorted_ = true;
    std::ranges::sort(draws_, {}, [](const Draw& draw) { return std::tie(draw.state, draw.order); });
    std::vector<std::array<std::uint32_t, 2>> records;
    for (std::uint32_t i = 0; i < draws_.size(); ++i) {
        draws_[i].command.baseInstance = i;
        records.push_back({draws_[i].instance, draws_[i].material});
    }
    drawBuffer_.upload(std::span<const std::array<std::uint32_t, 2>>(records));
}

void DrawList::select(const std::function<bool(std::uint32_t)>& visible) {
    sort();
    commands_.clear();
    batches_.clear();
    for (const Draw& draw : draws_) {
        if (draw.command.count == 0 || !visible(draw.instance)) continue;
        if (batches_.empty() || batches_.back().state != draw.state) {
            batches_.push_back({draw.state, static_cast<std::uint32_t>(commands_.size()), 0});
        }
        commands_.push_back(draw.command);
        ++batches_.back().commandCount;
    }
    commandBuffer_.upload(std::span<const Command>(commands_));
}

}  // namespace candela
