// Edits of the lights of a GpuScene.

#include "render/gpu_scene/buffer_source.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "scene/model/animation.h"
#include "scene/validate/scene_rules.h"

#include <candela/brdf.h>
#include <candela/error.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace candela {

namespace {

/// How much brighter than diffuse white the peak of a material's specular lobe is: F D G / (4 (n·l)(n·v)) at
/// normal incidence over 1 / pi, 1 or more. A texture of roughness may hold any.
double lobeHeight(const Material& material) {
    if (material.unlit) return 1.0;
    const double roughness = material.metallicRoughnessTexture ? 0.0 : material.roughness;
    const double alpha = std::max(roughness * roughness, minAlpha);
    const double f0 = material.metallic > 0.0f ? 1.0 : 0.04;
    return std::max(1.0, f0 / (4.0 * alpha * alpha));
}

/// Can `GpuLights::change` make one light the other?
bool haveRecordsAlike(const Light& a, const Light& b) {
    return a.type == b.type && a.castsShadow == b.castsShadow && a.radius == b.radius &&
           a.range.has_value() == b.range.has_value() && a.node == b.node;
}

WorldLight lightOf(const LightRecord& record, std::size_t index) {
    const auto refuse = [&](const char* rule) {
        throw Error(ErrorKind::badInput, "", "light " + std::to_string(index) + ": " + rule);
    };
    WorldLight light;
    light.type = record.type == 0.0f   ? LightType::point
                 : record.type == 1.0f ? LightType::spot
                                       : LightType::directional;
    if (record.type != static_cast<float>(light.type)) refuse("its type has to be 0, 1 or 2");
    if (record.castsShadow != 0.0f && record.castsShadow != 1.0f) refuse("its castsShadow has to be 0 or 1");
    light.position = {record.position[0], record.position[1], record.position[2]};
    light.range = record.range;
    light.direction = {record.direction[0], record.direction[1], record.direction[2]};
    light.intensity = {record.intensity[0], record.intensity[1], record.intensity[2]};
    light.innerConeAngle = record.innerConeAngle;
    light.outerConeAngle = record.outerConeAngle;
    light.castsShadow = record.castsShadow != 0.0f;
    light.radius = record.radius;
    return light;
}

}  // namespace

void GpuScene::State::setLights(const BufferRange& records, std::uint64_t count) {
    static_assert(sizeof(LightRecord) == 64);
    if (count > std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorKind::limit, "", std::to_string(count) + " lights are more than 32 bits count");
    const std::vector<std::byte> bytes = readBytes(records, count * sizeof(LightRecord), "the lights");
    std::vector<WorldLight> placed(count);
    for (std::size_t i = 0; i < count; ++i) {
        LightRecord record;
        std::memcpy(&record, bytes.data() + i * sizeof record, sizeof record);
        placed[i] = lightOf(record, i);
    }
    setLights(placed);
}

void GpuScene::State::requireSceneLights() const {
    if (lightsFollowNodes_) return;
    throw Error(ErrorKind::badInput, "",
                "setLights has replaced the lights of the scene: others can not be added to those");
}

LightHandle GpuScene::State::addLight(const Light& light) {
    requireSceneLights();
    const std::uint32_t index = lightSlots.next();
    const ErrorContext element("light", index, light.name);
    validateLight(light, sceneState, element);
    nodeSlots.requireAlive(light.node, element);
    if (index >= sceneState.lights.size()) sceneState.lights.resize(index + 1);
    sceneState.lights[index] = light;
    lightSlots.add();
    lightsEdited_ = true;
    if (light.node) {
        if (*light.node >= nodeLights_.size()) nodeLights_.resize(sceneState.nodes.size());
        nodeLights_[*light.node].push_back(index);
    }
    return {index, lightSlots.generation(index)};
}

void GpuScene::State::setLight(std::uint32_t index, const Light& light) {
    const ErrorContext element("light", index, light.name);
    validateLight(light, sceneState, element);
    nodeSlots.requireAlive(light.node, element);
    Light& kept = sceneState.lights[index];
    const bool alike = haveRecordsAlike(kept, light);
    const std::optional<std::uint32_t> before = kept.node;
    kept = light;
    lightTracks_.remove(index);
    if (alike) return updateLight(index);
    lightsEdited_ = true;
    if (before) std::erase(nodeLights_[*before], index);
    if (!light.node) return;
    if (*light.node >= nodeLights_.size()) nodeLights_.resize(sceneState.nodes.size());
    nodeLights_[*light.node].push_back(index);
}

void GpuScene::State::removeLight(std::uint32_t index) {
    if (const std::optional<std::uint32_t> node = sceneState.lights[index].node)
        std::erase(nodeLights_[*node], index);
    sceneState.lights[index] = {};
    lightTracks_.remove(index);
    lightSlots.remove(index);
    lightsEdited_ = true;
}

/// Uploads all lights. One whose place overflows is dark.
void GpuScene::State::resetLights() {
    std::vector<WorldLight> placed;
    lightPlaces_.assign(sceneState.lights.size(), 0);
    for (std::uint32_t i = 0; i < sceneState.lights.size(); ++i) {
        if (!lightSlots.isAlive(i)) continue;
        lightPlaces_[i] = static_cast<std::uint32_t>(placed.size());
        const Light& light = sceneState.lights[i];
        WorldLight& world = placed.emplace_back(worldLight(light, transforms.world()));
        if (light.node && !isVisible_[*light.node]) world.intensity = glm::vec3(0.0f);
        if (allFinite(world.position) && allFinite(world.direction)) continue;
        world.position = glm::vec3(0.0f);
        world.direction = glm::vec3(0.0f, 0.0f, -1.0f);
        world.intensity = glm::vec3(0.0f);
    }
    const std::uint32_t sample = lights.sample();
    lights.set(placed, rangeRule());
    lights.setSample(sample);
    lightsEdited_ = false;
}

RangeRule GpuScene::State::rangeRule() {
    double highest = 1.0;
    for (const Material& material : sceneState.materials) highest = std::max(highest, lobeHeight(material));
    return {instances.bounds(), options.rangeLoss / highest};
}

void GpuScene::State::updateRanges() {
    const RangeRule rule = rangeRule();
    if (!lights.areAssigned(rule)) lights.assignRanges(rule);
}

}  // namespace candela
