// The time of a GpuScene, and what animations and edits change without moving it: materials, lights and
// visibility.

#include "gl/state_guard.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "render/gpu_scene/lobe_records.h"
#include "scene/model/animation.h"
#include "scene/model/frame_callback.h"
#include "scene/model/material_textures.h"
#include "scene/validate/scene_rules.h"

#include <candela/error.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace candela {

namespace {

bool hasTextures(const Material& material) {
    return std::ranges::any_of(
        materialTextures(), [&](const MaterialTexture& texture) { return texture.of(material).has_value(); });
}

/// Do rays pass through surfaces of the two materials alike?
bool letLightThroughAlike(const Material& a, const Material& b) {
    if (!letsLightThrough(a) && !letsLightThrough(b)) return true;
    return a.alphaMode == b.alphaMode && a.baseColor == b.baseColor && a.metallic == b.metallic &&
           a.alphaCutoff == b.alphaCutoff && a.unlit == b.unlit && a.baseColorTexture == b.baseColorTexture &&
           a.transmission == b.transmission;
}

}  // namespace

void GpuScene::State::setTime(double seconds) {
    if (!std::isfinite(seconds)) throw Error(ErrorKind::badInput, "", "the time must be a finite number");
    if (seconds == transforms.time()) return;
    std::shared_ptr<const SceneUpdate> update = updateOf(seconds);
    transforms.setTime(seconds, update);
    update_ = std::move(update);
    timeChanged_ = true;
}

void GpuScene::State::playAnimations(std::span<const std::uint32_t> animations) {
    for (const std::uint32_t index : animations)
        requireIndex("animation", index, sceneState.animations.size());
    for (Animation& animation : sceneState.animations) animation.plays = false;
    for (const std::uint32_t index : animations) sceneState.animations[index].plays = true;
    transforms.resetAnimated();
    deformations.selectAnimations();
    materialTracks_.select();
    lightTracks_.select();
    nodeTracks_.select();
    timeChanged_ = true;
}

void GpuScene::State::setMaterial(std::uint32_t index, const Material& material) {
    requireIndex("material", index, sceneState.materials.size());
    const ErrorContext element("material", index, material.name);
    validateMaterial(material, sceneState, element);
    requireFreshImages(material, element);
    if (isOfMesh(index)) requireDetail(material, element);
    materials.requireUvs(index, material);
    std::optional<gl::StateGuard> pixelStorage;
    if (hasTextures(material)) pixelStorage.emplace(*binding, "a GpuScene");
    applyMaterial(index, material);
    materialTracks_.remove(index);
}

/// What throws comes first.
void GpuScene::State::applyMaterial(std::uint32_t index, const Material& material) {
    materials.reserve(material);
    draws.setMaterial(index, material, images);
    if (!letLightThroughAlike(material, sceneState.materials[index])) ++alphaVersion;
    sceneState.materials[index] = material;
    materials.set(index, material);
    cages.setMaterial(index, material);
    rangeRuleChanged_ = true;
}

/// A time at which a material has no lobes differs from the others in its record alone.
void GpuScene::State::reserveAnimatedLobes() {
    for (const Animation& animation : sceneState.animations) {
        for (const PropertyChannel& channel : animation.properties) {
            if (elementOf(channel.property) != AnimatedElement::material) continue;
            Material posed = sceneState.materials[channel.element];
            for (const float time : channel.times) {
                setProperty(channel, sampleProperty(channel, time), posed);
                materials.reserve(posed);
            }
        }
    }
}

/// Whether the callback changes the element of a channel here: cameras are no part of the scene on the
/// device, and elements that edits have replaced follow it no more.
bool GpuScene::State::takes(const PropertyChannel& channel) const {
    switch (elementOf(channel.property)) {
        case AnimatedElement::node:
            return nodeTracks_.takes(channel.element);
        case AnimatedElement::material:
            return materialTracks_.takes(channel.element);
        case AnimatedElement::light:
            return lightTracks_.takes(channel.element);
        default:
            return false;
    }
}

/// What the frame callback sets at a time, once it fits the scene.
std::shared_ptr<const SceneUpdate> GpuScene::State::updateOf(double seconds) const {
    std::shared_ptr<const SceneUpdate> update = updateAt(sceneState, seconds);
    if (!update) return update;
    const ErrorContext callback("frame callback");
    for (const SceneUpdate::NodeMatrix& node : update->nodes)
        callback.requireIndex("node", node.node, sceneState.nodes.size());
    for (std::size_t i = 0; i < update->properties.size(); ++i) {
        if (takes(update->properties[i])) requireChannel(update->properties[i], i, sceneState, callback);
    }
    for (const SceneUpdate::MeshVertices& moved : update->meshes) {
        callback.requireIndex("mesh", moved.mesh, sceneState.meshes.size());
        ErrorContext("mesh", moved.mesh, sceneState.meshes[moved.mesh].name)
            .requireCount("vertices of the frame callback", moved.positions.size(), "vertices",
                          meshes.places()[moved.mesh].vertexCount);
    }
    for (const SceneUpdate::CageVertices& moved : update->cages) {
        callback.requireIndex("cage", moved.cage, sceneState.cages.size());
        const Cage& cage = sceneState.cages[moved.cage];
        ErrorContext("cage", moved.cage, cage.name)
            .requireCount("vertices of the frame callback", moved.positions.size(), "vertices",
                          cage.positions.size());
    }
    return update;
}

/// Nodes and cages take it when they are posed.
void GpuScene::State::takeUpdate() {
    if (!update_) return;
    for (const SceneUpdate::MeshVertices& moved : update_->meshes)
        moveVertices(moved.mesh, moved.positions, moved.normals);
    materialTracks_.setGiven(update_->properties);
    nodeTracks_.setGiven(update_->properties);
    lightTracks_.setGiven(update_->properties);
}

void GpuScene::State::poseProperties() {
    const double time = transforms.time();
    materialTracks_.pose(
        time, [&](std::uint32_t index, const Material& material) { applyMaterial(index, material); });
    nodeTracks_.pose(time, [&](std::uint32_t index, const Node& node) {
        sceneState.nodes[index].visible = node.visible;
        updateVisibility(index);
    });
    lightTracks_.pose(time, [&](std::uint32_t index, const Light& light) {
        sceneState.lights[index] = light;
        updateLight(index);
    });
}

void GpuScene::State::updateLight(std::uint32_t index) {
    if (!lightsFollowNodes_ || lightsEdited_) return;
    const Light& light = sceneState.lights[index];
    WorldLight placed = worldLight(light, transforms.world());
    if (light.node && !isVisible_[*light.node]) placed.intensity = glm::vec3(0.0f);
    lights.change(lightPlace(index), placed);
}

void GpuScene::State::setVisibility(std::uint32_t node, Visibility visibility) {
    requireIndex("node", node, sceneState.nodes.size());
    isHidden_[node] = visibility == Visibility::hidden;
    applyVisibility(node);
}

/// Brings the visibility of a node, and of what is below it, in step with `Node::visible`.
void GpuScene::State::updateVisibility(std::uint32_t root) {
    std::vector<std::uint32_t> open{root};
    while (!open.empty()) {
        const std::uint32_t index = open.back();
        open.pop_back();
        const Node& node = sceneState.nodes[index];
        const bool visible = node.visible && (!node.parent || isVisible_[*node.parent]);
        if (visible == isVisible_[index]) continue;
        isVisible_[index] = visible;
        applyVisibility(index);
        if (index < nodeLights_.size())
            std::ranges::for_each(nodeLights_[index], [&](auto i) { updateLight(i); });
        transforms.forEachChild(index, [&](std::uint32_t child) { open.push_back(child); });
    }
}

void GpuScene::State::applyVisibility(std::uint32_t node) {
    const bool hidden = isHidden_[node] || !isVisible_[node];
    if (const std::optional<std::uint32_t> mesh = instances.meshOf(node)) instances.setHidden(*mesh, hidden);
    if (const std::optional<std::uint32_t> cage = instances.cageOf(node)) {
        instances.setHidden(*cage, hidden);
        cages.setVisibility(instances[*cage].cageInstance, hidden ? Visibility::hidden : Visibility::shown);
    }
}

}  // namespace candela
