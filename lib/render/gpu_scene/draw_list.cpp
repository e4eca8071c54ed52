#include "render/gpu_scene/draw_list.h"

#include "scene/model/material_textures.h"
#include "scene/model/uv_sets.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace candela {

namespace {

const Material& materialOf(std::span<const Material> materials, std::uint32_t index) {
    static const Material none;
    return index < materials.size() ? materials[index] : none;
}

bool isEmissive(const Material& material) {
    return material.unlit || material.emission * material.emissionStrength != glm::vec3(0.0f);
}

enum class Colors { none, perVertex };

Backdrop backdropOf(const Material& material) {
    if (!transmits(material)) return Backdrop::none;
    if (material.volume.thickness > 0.0f && material.volume.dispersion > 0.0f) return Backdrop::dispersed;
    return material.roughness > 0.0f && material.ior > 1.0f ? Backdrop::blurred : Backdrop::sharp;
}

/// An alpha of 1 everywhere blends nothing.
bool blends(const Material& material, Colors colors) {
    return material.alphaMode == AlphaMode::blend &&
           (material.baseColor.a < 1.0f || material.baseColorTexture || colors == Colors::perVertex);
}

bool isPlain(const Material& material, Colors colors, OcclusionTextures occlusion) {
    if (material.occlusionTexture && occlusion == OcclusionTextures::read) return false;
    return !isEmissive(material) && !isExtended(material) && material.alphaMode == AlphaMode::opaque &&
           !material.baseColorTexture && !material.metallicRoughnessTexture && !material.normalTexture &&
           colors == Colors::none;
}

/// Does `next` draw the same vertices as `command`, with the record that follows those of `command`?
bool continues(const DrawCommand& command, const DrawCommand& next) {
    return command.firstIndex == next.firstIndex && command.count == next.count &&
           command.baseVertex == next.baseVertex &&
           command.baseInstance + command.instanceCount == next.baseInstance;
}

/// The place of the occlusion texture in `materialTextures`.
constexpr std::size_t occlusionIndex = 4;

bool needsDetail(const Scene& scene, const Mesh& mesh) {
    if (!scene.images.empty() && uvSetsOf(mesh) != 0) return true;
    const auto count = static_cast<std::uint32_t>(scene.materials.size());
    const MeshParts parts = partsOf(mesh);
    const Colors colors = parts.hasColors ? Colors::perVertex : Colors::none;
    return std::ranges::any_of(parts.parts, [&](const MeshParts::Part& part) {
        return !isPlain(materialOf(scene.materials, part.material.value_or(count)), colors,
                        OcclusionTextures::read);
    });
}

bool animatesMaterials(const Animation& animation) {
    return std::ranges::any_of(animation.properties, [](const PropertyChannel& channel) {
        return elementOf(channel.property) == AnimatedElement::material;
    });
}

/// How many pairs of sets from 2 on those of a material's textures that are among `textures` read.
std::uint32_t furtherUvPairs(const Material& material, std::span<const MaterialTexture> textures) {
    std::uint32_t pairs = 0;
    for (const MaterialTexture& use : textures) {
        const std::optional<Texture>& texture = use.of(material);
        if (texture && texture->uvSet >= basicUvSets)
            pairs = std::max(pairs, (texture->uvSet - basicUvSets) / 2 + 1);
    }
    return pairs;
}

}  // namespace

GpuMeshes::Detail detailOf(const Scene& scene) {
    const bool needed =
        std::ranges::any_of(scene.animations, animatesMaterials) ||
        std::ranges::any_of(scene.meshes, [&](const Mesh& mesh) { return needsDetail(scene, mesh); });
    return needed ? GpuMeshes::Detail::everything : GpuMeshes::Detail::positionsAndNormals;
}

bool DrawList::isPrepared(const MeshParts& parts) const {
    return std::ranges::all_of(parts.parts, [&](const MeshParts::Part& part) {
        const VertexKind vertices{parts.hasColors, part.unlit};
        return materialKeys_[part.material.value_or(noMaterial_)][vertices.index()].has_value();
    });
}

void DrawList::prepare(const MeshParts& parts, std::span<const Material> materials, GpuImages& images) {
    for (const MeshParts::Part& part : parts.parts)
        requireKey(part.material.value_or(noMaterial_), {parts.hasColors, part.unlit}, materials, images);
}

void DrawList::addMesh(std::uint32_t instance, const DrawGeometry& geometry, std::uint32_t mesh,
                       const MeshParts& parts, const MeshPlace& place, std::span<const Material> materials,
                       GpuImages& images) {
    prepare(parts, materials, images);
    const std::span<Draw> draws = takeDraws(instance, parts.parts.size());
    // Meshes with further texture coordinates come first in a new scene.
    const std::uint32_t order = parts.hasFurtherUvs ? mesh : mesh | 1u << 31;
    for (std::size_t i = 0; i < draws.size(); ++i) {
        const MeshParts::Part& part = parts.parts[i];
        Draw& draw = draws[i];
        draw.command = {part.indices.count, 1, place.firstIndex + part.indices.first, place.baseVertex, 0};
        draw.instance = instance;
        draw.material = part.material.value_or(noMaterial_);
        draw.meshOrder = order;
        draw.indexInMesh = part.indices.first;
        draw.geometry = geometry;
        draw.hasColors = parts.hasColors;
        draw.topology = part.topology;
        draw.unlit = part.unlit;
        finishDraw(draw);
    }
}

void DrawList::addCage(std::uint32_t instance, std::uint32_t surface, std::span<const std::uint32_t> parts,
                       std::span<const Material> materials, GpuImages& images) {
    prepare(parts, materials, images);
    const std::span<Draw> draws = takeDraws(instance, parts.size());
    for (std::uint32_t part = 0; part < parts.size(); ++part) {
        Draw& draw = draws[part];
        draw.instance = instance;
        draw.material = parts[part];
        draw.part = part;
        draw.geometry = {DrawGeometry::Kind::cage, surface};
        finishDraw(draw);
    }
}

void DrawList::prepare(std::span<const std::uint32_t> parts, std::span<const Material> materials,
                       GpuImages& images) {
    for (const std::uint32_t material : parts) requireKey(material, {false, false}, materials, images);
}

bool DrawList::isPrepared(std::span<const std::uint32_t> parts) const {
    return std::ranges::all_of(parts, [&](std::uint32_t i) { return materialKeys_[i][0].has_value(); });
}

void DrawList::requireKey(std::uint32_t material, const VertexKind& vertices,
                          std::span<const Material> materials, GpuImages& images) {
    std::optional<PipelineKey>& key = materialKeys_[material][vertices.index()];
    if (!key) key = materialKey(materialOf(materials, material), vertices, images);
}

std::span<DrawList::Draw> DrawList::takeDraws(std::uint32_t instance, std::size_t count) {
    if (instance >= spans_.size()) spans_.resize(instance + 1);
    std::vector<std::uint32_t>& unused = freeDraws_[static_cast<std::uint32_t>(count)];
    DrawSpan span{static_cast<std::uint32_t>(draws_.size()), static_cast<std::uint32_t>(count)};
    if (unused.empty()) {
        draws_.resize(draws_.size() + count);
    } else {
        span.first = unused.back();
        unused.pop_back();
    }
    spans_[instance] = span;
    unplaced_ = true;
    const std::span<Draw> draws = drawsOf(instance);
    std::ranges::fill(draws, Draw{});
    return draws;
}

void DrawList::finishDraw(Draw& draw) {
    drawsOfMaterial_[draw.material].draws.push_back(static_cast<std::uint32_t>(&draw - draws_.data()));
    mark(draw);
}

void DrawList::remove(std::uint32_t instance) {
    for (Draw& draw : drawsOf(instance)) {
        if (draw.group != nullptr) draw.group->changed = true;
        draw.group = nullptr;
        draw.removed = true;
        hasRemoved_ = true;
        forgetOfMaterial(draw.material);
    }
    if (instance >= spans_.size()) return;
    const DrawSpan span = std::exchange(spans_[instance], {});
    if (span.count > 0) freeDraws_[span.count].push_back(span.first);
    unplaced_ = true;
}

/// The list of a material keeps draws that have been removed until they are the most of it.
void DrawList::forgetOfMaterial(std::uint32_t material) {
    std::vector<std::uint32_t>& draws = drawsOfMaterial_[material].draws;
    if (2 * ++drawsOfMaterial_[material].removed <= draws.size()) return;
    std::erase_if(draws,
                  [&](std::uint32_t i) { return draws_[i].removed || draws_[i].material != material; });
    std::ranges::sort(draws);
    const auto repeated = std::ranges::unique(draws);
    draws.erase(repeated.begin(), repeated.end());
    drawsOfMaterial_[material].removed = 0;
}

PipelineKey DrawList::materialKey(const Material& material, const VertexKind& vertices, GpuImages& images) {
    PipelineKey key;
    key.doubleSided = material.doubleSided;
    const Colors colors = vertices.hasColors ? Colors::perVertex : Colors::none;
    if (!vertices.unlit && isPlain(material, colors, occlusionTextures_)) return key;
    key.program = PipelineKey::Program::textured;
    key.emissive = vertices.unlit || isEmissive(material);
    key.transparent = blends(material, colors) || (!vertices.unlit && transmits(material));
    if (!vertices.unlit) key.backdrop = backdropOf(material);
    const std::span<const MaterialTexture> textures = materialTextures();
    for (std::size_t i = 0; i < key.textures.size(); ++i) {
        const std::optional<Texture>& texture = textures[i].of(material);
        const bool isRead = i != occlusionIndex || (texture && occlusionTextures_ == OcclusionTextures::read);
        if (isRead) key.textures[i] = images.get(texture, textures[i].content);
    }
    const bool extended = !vertices.unlit && isExtended(material);
    key.furtherUvPairs = furtherUvPairs(material, extended ? textures : textures.first(basicTextureCount));
    if (!extended) return key;
    key.program = PipelineKey::Program::extended;
    key.lobeTextures = lobeSet(lobeTexturesOf(material, images));
    return key;
}

std::uint32_t DrawList::lobeSet(const LobeTextures& textures) {
    const auto [entry, isNew] =
        lobeSetOf_.try_emplace(textures, static_cast<std::uint32_t>(lobeSets_.size()));
    if (isNew) lobeSets_.push_back(textures);
    return entry->second;
}

std::span<DrawList::Draw> DrawList::drawsOf(std::uint32_t instance) {
    if (instance >= spans_.size()) return {};
    return std::span(draws_).subspan(spans_[instance].first, spans_[instance].count);
}

std::span<const DrawList::Draw> DrawList::drawsOf(std::uint32_t instance) const {
    if (instance >= spans_.size()) return {};
    return std::span(draws_).subspan(spans_[instance].first, spans_[instance].count);
}

void DrawList::mark(Draw& draw) {
    if (draw.pending) return;
    pending_.push_back(static_cast<std::uint32_t>(&draw - draws_.data()));
    draw.pending = true;
}

void DrawList::setWinding(std::uint32_t instance, Winding winding) {
    for (Draw& draw : drawsOf(instance)) {
        const bool mirrored = winding == Winding::reversed;
        if (draw.mirrored == mirrored) continue;
        draw.mirrored = mirrored;
        mark(draw);
    }
}

void DrawList::setMaterial(std::uint32_t index, const Material& material, GpuImages& images) {
    if (index >= materialKeys_.size()) return;
    MaterialKeys keys = materialKeys_[index];
    for (const VertexKind& vertices : vertexKinds) {
        std::optional<PipelineKey>& key = keys[vertices.index()];
        if (key) key = materialKey(material, vertices, images);
    }
    if (keys == materialKeys_[index]) return;
    materialKeys_[index] = keys;
    for (const std::uint32_t i : drawsOfMaterial_[index].draws) {
        if (!draws_[i].removed && draws_[i].material == index) mark(draws_[i]);
    }
}

void DrawList::setOcclusionTextures(OcclusionTextures textures, std::span<const Material> materials,
                                    GpuImages& images) {
    if (textures == occlusionTextures_) return;
    occlusionTextures_ = textures;
    for (std::uint32_t i = 0; i < materials.size(); ++i) setMaterial(i, materials[i], images);
}

void DrawList::setSurface(std::uint32_t instance, std::uint32_t surface) {
    const DrawGeometry geometry{DrawGeometry::Kind::cage, surface};
    for (Draw& draw : drawsOf(instance)) {
        if (draw.geometry == geometry) continue;
        draw.geometry = geometry;
        draw.command.count = 0;
        mark(draw);
    }
}

void DrawList::setRanges(std::uint32_t instance, std::span<const IndexRange> ranges) {
    for (Draw& draw : drawsOf(instance)) {
        draw.command.firstIndex = ranges[draw.part].first;
        draw.command.count = ranges[draw.part].count;
    }
}

PipelineKey DrawList::keyOf(const Draw& draw) const {
    PipelineKey key = *materialKeys_[draw.material][VertexKind{draw.hasColors, draw.unlit}.index()];
    key.mirrored = draw.mirrored;
    key.geometry = draw.geometry;
    key.topology = draw.topology;
    key.unlit = draw.unlit;
    if (draw.topology != Topology::triangles) {
        key.doubleSided = true;
        key.mirrored = false;
    }
    return key;
}

DrawGeometry DrawList::geometryOf(std::uint32_t instance) const {
    const std::span<const Draw> draws = drawsOf(instance);
    return draws.empty() ? DrawGeometry{} : draws.front().geometry;
}

std::vector<DrawnPart> DrawList::partsOf(std::uint32_t instance) const {
    std::vector<DrawnPart> parts;
    for (const Draw& draw : drawsOf(instance)) {
        if (draw.topology != Topology::triangles) continue;
        parts.push_back({{draw.command.firstIndex, draw.command.count}, draw.material});
    }
    return parts;
}

bool DrawList::hasTransparent() const {
    return std::ranges::any_of(groups_, [](const auto& entry) { return entry.first.transparent; });
}

/// Leaves out the occluded instances of a command, last, so that the order of the rest does not depend on
/// them.
void DrawList::addCommand(DrawSelection& selection, const DrawCommand& command) const {
    if (selection.occluded_.empty()) {
        selection.commands_.push_back(command);
        return;
    }
    DrawCommand piece = command;
    piece.instanceCount = 0;
    const auto finish = [&] {
        if (piece.instanceCount > 0) selection.commands_.push_back(piece);
        piece.baseInstance += piece.instanceCount + 1;
        piece.instanceCount = 0;
    };
    for (std::uint32_t i = 0; i < command.instanceCount; ++i) {
        if (std::ranges::binary_search(selection.occluded_, instanceOfRecord(command.baseInstance + i)))
            finish();
        else
            ++piece.instanceCount;
    }
    finish();
}

void DrawList::cull(DrawSelection& selection) const {
    selection.commands_.clear();
    selection.transparentInstances_.clear();
    selection.batches_.clear();
    auto& ordered = selection.ordered_;
    for (const auto& [key, group] : groups_) {
        ordered.clear();
        for (const std::uint32_t index : group.draws) {
            const Draw& draw = draws_[index];
            const DrawSelection::DistanceClass distance = selection.distances_[draw.instance];
            if (distance == DrawSelection::hidden || draw.command.count == 0) continue;
            if (key.transparent) selection.transparentInstances_.push_back(draw.instance);
            if (!ordered.empty() && continues(ordered.back().second, draw.command)) {
                ++ordered.back().second.instanceCount;
                ordered.back().first = std::min(ordered.back().first, distance);
            } else {
                ordered.emplace_back(distance, draw.command);
            }
        }
        if (ordered.empty()) continue;
        if (!key.transparent)
            std::ranges::stable_sort(ordered, {}, [](const auto& entry) { return entry.first; });
        const auto first = static_cast<std::uint32_t>(selection.commands_.size());
        for (const auto& [distance, command] : ordered) addCommand(selection, command);
        const auto end = static_cast<std::uint32_t>(selection.commands_.size());
        selection.batches_.push_back({key, first, end - first});
    }
    selection.commandBuffer_.upload(std::span<const DrawCommand>(selection.commands_));
}

}  // namespace candela
