#include "render/gpu_scene/draw_list.h"

#include "scene/geometry/topology.h"
#include "scene/model/material_textures.h"
#include "scene/model/uv_sets.h"

#include <algorithm>
#include <numeric>
#include <tuple>

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

Colors colorsOf(const Mesh& mesh) {
    return mesh.colors.empty() ? Colors::none : Colors::perVertex;
}

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

/// A mesh without submeshes is one submesh with the default material.
std::span<const Submesh> submeshesOf(const Mesh& mesh, const Submesh& whole) {
    return mesh.submeshes.empty() ? std::span(&whole, 1) : std::span(mesh.submeshes);
}

Submesh wholeOf(const Mesh& mesh) {
    return {0, static_cast<std::uint32_t>(mesh.indices.size()), std::nullopt};
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
    const Submesh whole = wholeOf(mesh);
    return std::ranges::any_of(submeshesOf(mesh, whole), [&](const Submesh& submesh) {
        return !isPlain(materialOf(scene.materials, submesh.material.value_or(count)), colorsOf(mesh),
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

GLenum modeOf(Topology topology) {
    if (topology == Topology::triangles) return GL_TRIANGLES;
    return topology == Topology::lines ? GL_LINES : GL_POINTS;
}

}  // namespace

GpuMeshes::Detail detailOf(const Scene& scene) {
    const bool needed =
        std::ranges::any_of(scene.animations, animatesMaterials) ||
        std::ranges::any_of(scene.meshes, [&](const Mesh& mesh) { return needsDetail(scene, mesh); });
    return needed ? GpuMeshes::Detail::everything : GpuMeshes::Detail::positionsAndNormals;
}

std::size_t DrawSelection::drawCount() const {
    std::size_t count = 0;
    for (const DrawCommand& command : commands_) count += command.instanceCount;
    return count;
}

bool DrawSelection::isExtended() const {
    return std::ranges::any_of(
        batches_, [](const DrawBatch& batch) { return batch.key.program == PipelineKey::Program::extended; });
}

Backdrop DrawSelection::backdrop() const {
    Backdrop highest = Backdrop::none;
    for (const DrawBatch& batch : batches_) highest = std::max(highest, batch.key.backdrop);
    return highest;
}

bool DrawSelection::emits(SurfaceSet set) const {
    return std::ranges::any_of(
        batches_, [&](const DrawBatch& batch) { return batch.key.emissive && batch.key.isIn(set); });
}

void DrawSelection::draw(const DrawBatch& batch) {
    glMultiDrawElementsIndirect(
        modeOf(batch.key.topology), GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(std::uintptr_t{batch.firstCommand} * sizeof(DrawCommand)),
        static_cast<GLsizei>(batch.commandCount), 0);
}

void DrawList::addMesh(std::uint32_t instance, const DrawGeometry& geometry, const Mesh& mesh,
                       const MeshPlace& place, std::span<const Material> materials, GpuImages& images) {
    const Submesh whole = wholeOf(mesh);
    for (const Submesh& submesh : submeshesOf(mesh, whole)) {
        if (submesh.indexCount == 0) continue;
        Draw draw;
        draw.command = {submesh.indexCount, 1, place.firstIndex + submesh.firstIndex, place.baseVertex, 0};
        draw.instance = instance;
        draw.material = submesh.material.value_or(static_cast<std::uint32_t>(materials.size()));
        draw.geometry = geometry;
        draw.hasColors = colorsOf(mesh) == Colors::perVertex;
        draw.topology = submesh.topology;
        draw.unlit = isUnlit(mesh, submesh);
        add(draw, materials, images);
    }
}

void DrawList::addCage(std::uint32_t instance, std::uint32_t surface, std::span<const std::uint32_t> parts,
                       std::span<const Material> materials, GpuImages& images) {
    for (std::uint32_t part = 0; part < parts.size(); ++part) {
        Draw draw;
        draw.instance = instance;
        draw.material = parts[part];
        draw.part = part;
        draw.geometry = {DrawGeometry::Kind::cage, surface};
        add(draw, materials, images);
    }
}

void DrawList::add(Draw draw, std::span<const Material> materials, GpuImages& images) {
    materialKeys_.resize(materials.size() + 1);
    const VertexKind vertices{draw.hasColors, draw.unlit};
    std::optional<PipelineKey>& key = materialKeys_[draw.material][vertices.index()];
    if (!key) key = materialKey(materialOf(materials, draw.material), vertices, images);
    const auto index = static_cast<std::uint32_t>(draws_.size());
    firstDraw_.resize(draw.instance + 1, index);
    draws_.push_back(draw);
    mark(draws_.back());
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

void DrawList::finish(std::size_t instanceCount) {
    firstDraw_.resize(instanceCount + 1, static_cast<std::uint32_t>(draws_.size()));
    firstOfMaterial_.assign(materialKeys_.size() + 1, 0);
    for (const Draw& draw : draws_) ++firstOfMaterial_[draw.material + 1];
    std::partial_sum(firstOfMaterial_.begin(), firstOfMaterial_.end(), firstOfMaterial_.begin());
    drawsOfMaterial_.resize(draws_.size());
    std::vector<std::uint32_t> next(firstOfMaterial_);
    for (std::uint32_t i = 0; i < draws_.size(); ++i) drawsOfMaterial_[next[draws_[i].material]++] = i;
    placeRecords();
}

void DrawList::placeRecords() {
    std::vector<std::uint32_t> order(draws_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) {
        const Draw& draw = draws_[i];
        return std::tuple(draw.geometry, draw.command.firstIndex, draw.command.baseVertex, draw.material);
    });
    std::vector<std::array<std::uint32_t, 3>> records;
    records.reserve(draws_.size());
    for (const std::uint32_t i : order) {
        draws_[i].command.baseInstance = static_cast<std::uint32_t>(records.size());
        records.push_back({draws_[i].instance, draws_[i].material, i});
        numberOfRecord_.push_back(i);
    }
    recordBuffer_ =
        gl::Buffer::immutable("draw records", std::span<const std::array<std::uint32_t, 3>>(records));
}

std::span<DrawList::Draw> DrawList::drawsOf(std::uint32_t instance) {
    const std::uint32_t first = firstDraw_[instance];
    return std::span(draws_).subspan(first, firstDraw_[instance + 1] - first);
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
    for (std::uint32_t i = firstOfMaterial_[index]; i < firstOfMaterial_[index + 1]; ++i)
        mark(draws_[drawsOfMaterial_[i]]);
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
    const std::uint32_t first = firstDraw_[instance];
    return first == firstDraw_[instance + 1] ? DrawGeometry{} : draws_[first].geometry;
}

std::vector<DrawnPart> DrawList::partsOf(std::uint32_t instance) const {
    std::vector<DrawnPart> parts;
    for (std::uint32_t i = firstDraw_[instance]; i < firstDraw_[instance + 1]; ++i) {
        if (draws_[i].topology != Topology::triangles) continue;
        parts.push_back({{draws_[i].command.firstIndex, draws_[i].command.count}, draws_[i].material});
    }
    return parts;
}

std::size_t DrawList::group() {
    if (pending_.empty()) return 0;
    Groups::iterator last = groups_.end();
    for (const std::uint32_t index : pending_) {
        Draw& draw = draws_[index];
        draw.pending = false;
        const PipelineKey key = keyOf(draw);
        if (last == groups_.end() || last->first != key) last = groups_.try_emplace(key).first;
        Group& target = last->second;
        if (draw.group == &target) continue;
        if (draw.group != nullptr) draw.group->changed = true;
        draw.group = &target;
        target.changed = true;
        target.added.push_back(index);
    }
    for (auto& [key, group] : groups_) {
        if (!group.changed) continue;
        group.changed = false;
        std::erase_if(group.draws,
                      [&, current = &group](std::uint32_t i) { return draws_[i].group != current; });
        const auto recordOf = [&](std::uint32_t i) { return draws_[i].command.baseInstance; };
        std::ranges::sort(group.added, {}, recordOf);
        const auto middle = static_cast<std::ptrdiff_t>(group.draws.size());
        group.draws.insert(group.draws.end(), group.added.begin(), group.added.end());
        std::ranges::inplace_merge(group.draws, group.draws.begin() + middle, {}, recordOf);
        group.added.clear();
    }
    std::erase_if(groups_, [](const auto& entry) { return entry.second.draws.empty(); });
    const std::size_t count = pending_.size();
    pending_.clear();
    return count;
}

bool DrawList::hasTransparent() const {
    return std::ranges::any_of(groups_, [](const auto& entry) { return entry.first.transparent; });
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
        for (const auto& [distance, command] : ordered) selection.commands_.push_back(command);
        selection.batches_.push_back({key, first, static_cast<std::uint32_t>(ordered.size())});
    }
    selection.commandBuffer_.upload(std::span<const DrawCommand>(selection.commands_));
}

}  // namespace candela
