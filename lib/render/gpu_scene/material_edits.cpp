// Edits of the materials and the images of a GpuScene.

#include "gl/state_guard.h"
#include "render/gpu_scene/buffer_source.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "scene/model/material_textures.h"
#include "scene/validate/scene_rules.h"

#include <candela/error.h>

#include <algorithm>
#include <cstring>

namespace candela {

namespace {

bool reads(const Material& material, std::uint32_t image) {
    return std::ranges::any_of(materialTextures(), [&](const MaterialTexture& texture) {
        const std::optional<Texture>& use = texture.of(material);
        return use && use->image == image;
    });
}

}  // namespace

void GpuScene::State::requireFreshImages(const Material& material, const ErrorContext& element) const {
    for (const MaterialTexture& texture : materialTextures()) {
        if (const std::optional<Texture>& use = texture.of(material))
            imageSlots.requireAlive(use->image, element);
    }
}

/// A scene without attributes of vertices, which had nothing that reads them, has no texture coordinates of
/// meshes.
void GpuScene::State::requireDetail(const Material& material, const ErrorContext& element) const {
    if (meshes.hasDetail()) return;
    for (const MaterialTexture& texture : materialTextures()) {
        if (texture.of(material))
            element.refuse(
                "reads texture coordinates, but the scene was made without (GpuSceneOptions::vertexDetail)",
                ErrorKind::unsupported);
    }
}

bool GpuScene::State::isOfMesh(std::uint32_t material) const {
    const auto isIt = [&](const MeshParts::Part& part) { return part.material == material; };
    return std::ranges::any_of(meshParts,
                               [&](const MeshParts& mesh) { return std::ranges::any_of(mesh.parts, isIt); });
}

MaterialHandle GpuScene::State::addMaterial(const Material& material) {
    const std::uint32_t index = materialSlots.next();
    const ErrorContext element("material", index, material.name);
    validateMaterial(material, sceneState, element);
    requireFreshImages(material, element);
    materials.grow(index + 1);
    materials.reserve(material);
    draws.growMaterials(index + 1);
    if (index >= sceneState.materials.size()) sceneState.materials.resize(index + 1);
    materialSlots.add();
    materials.setCommonUvs(index, ~UvSets{0});
    applyMaterial(index, material);
    return {index, materialSlots.generation(index)};
}

void GpuScene::State::removeMaterial(std::uint32_t index) {
    const ErrorContext element("material", index, sceneState.materials[index].name);
    element.require(!isOfMesh(index), "a mesh has it: it can not be removed");
    for (const Cage& cage : sceneState.cages) {
        const bool hasIt = std::ranges::find(cage.faceMaterials, index) != cage.faceMaterials.end();
        element.require(!hasIt, "a cage has it: it can not be removed");
    }
    applyMaterial(index, {});
    materialTracks_.remove(index);
    draws.removeMaterial(index);
    materialSlots.remove(index);
}

ImageHandle GpuScene::State::addImage(const Image& image) {
    const std::uint32_t index = imageSlots.next();
    validateImage(image, ErrorContext("image", index, image.name));
    images.set(index, image);
    imageSlots.add();
    if (index >= sceneState.images.size()) sceneState.images.resize(index + 1);
    sceneState.images[index] = {image.name, image.width, image.height, image.format, {}};
    return {index, imageSlots.generation(index)};
}

void GpuScene::State::replaceImage(std::uint32_t index, const Image& image) {
    validateImage(image, ErrorContext("image", index, image.name));
    const gl::StateGuard pixelStorage(*binding, "a GpuScene");
    images.replace(index, image);
    sceneState.images[index] = {image.name, image.width, image.height, image.format, {}};
    for (std::uint32_t i = 0; i < sceneState.materials.size(); ++i) {
        if (reads(sceneState.materials[i], index)) draws.setMaterial(i, sceneState.materials[i], images);
    }
    imageChanged(index);
}

/// What rays pass through of surfaces with the image may be another part of them.
void GpuScene::State::imageChanged(std::uint32_t index) {
    ++imagesVersion;
    const auto isCutOut = [&](const Material& material) {
        return letsLightThrough(material) && reads(material, index);
    };
    if (std::ranges::any_of(sceneState.materials, isCutOut)) ++alphaVersion;
}

void GpuScene::State::removeImage(std::uint32_t index) {
    const ErrorContext element("image", index, sceneState.images[index].name);
    const auto readsIt = [&](const Material& material) { return reads(material, index); };
    element.require(std::ranges::none_of(sceneState.materials, readsIt),
                    "a material reads it: it can not be removed");
    images.remove(index);
    sceneState.images[index] = {};
    ++imagesVersion;
    imageSlots.remove(index);
}

void GpuScene::State::setPixels(std::uint32_t index, const ImageRegion& region,
                                std::span<const std::byte> pixels) {
    const Image& image = sceneState.images[index];
    const ErrorContext element("image", index, image.name);
    const bool within = region.x <= image.width && region.width <= image.width - region.x &&
                        region.y <= image.height && region.height <= image.height - region.y;
    element.require(within, "the region leaves it");
    element.requireCount("bytes", pixels.size(), "the region",
                         std::uint64_t{region.width} * region.height * texelSize(image.format));
    if (pixels.empty()) return;
    for (std::size_t at = 0; image.format == PixelFormat::rgba32f && at < pixels.size();
         at += sizeof(float)) {
        float value = 0.0f;
        std::memcpy(&value, pixels.data() + at, sizeof value);
        element.requireFinite("each number of its pixels", value);
    }
    const gl::StateGuard pixelStorage(*binding, "a GpuScene");
    images.setPixels(index, region, pixels);
    imageChanged(index);
}

void GpuScene::State::setPixels(std::uint32_t index, const ImageRegion& region, const BufferRange& pixels) {
    const std::size_t texel = texelSize(sceneState.images[index].format);
    const std::uint64_t bytes = std::uint64_t{region.width} * region.height * texel;
    setPixels(index, region, readBytes(pixels, bytes, "the pixels of an image"));
}

}  // namespace candela
