#include "render/gpu_scene/gpu_scene_state.h"

#include "render/gpu_scene/instance_records.h"
#include "render/gpu_scene/material_records.h"
#include "render/layout.h"
#include "scene/validate/finite.h"
#include "scene/validate/validate_parts.h"

#include <candela/error.h>

#include <algorithm>
#include <cassert>
#include <string>

namespace candela {

namespace {

Scene changingParts(const Scene& scene) {
    Scene parts;
    parts.nodes = scene.nodes;
    parts.lights = scene.lights;
    parts.animations = scene.animations;
    parts.cages = scene.cages;
    parts.skins = scene.skins;
    parts.materials = scene.materials;
    for (const Image& image : scene.images)
        parts.images.push_back({image.name, image.width, image.height, image.format, {}});
    return parts;
}

std::vector<Instance> instancesOf(const Scene& scene) {
    std::vector<Instance> instances;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        if (scene.nodes[i].mesh) instances.push_back({i, *scene.nodes[i].mesh, 0});
    }
    std::uint32_t shown = 0;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        if (scene.nodes[i].cage) instances.push_back({i, std::nullopt, shown++});
    }
    return instances;
}

}  // namespace

GpuScene::State::State(const Context& context, const Scene& scene, const GpuSceneOptions& sceneOptions)
    : binding(context.state().binding),
      options(sceneOptions),
      sceneState(changingParts(scene)),
      triangles(candela::triangleCount(scene)),
      materialCount(static_cast<std::uint32_t>(scene.materials.size())),
      surfaceUvs(scene),
      meshes(scene.meshes, detailOf(scene)),
      images(scene.images),
      lights(sceneOptions),
      cages(context, sceneState, options),
      instances(instancesOf(scene)),
      instanceSpheres(instances.size()),
      instanceRecords(GL_RGBA32F, "instances"),
      materialRecordTexture(GL_RGBA32UI, "materials"),
      vertexArray("scene"),
      hidden_(instances.size()) {
    addDraws(scene);
    images.forgetSources();
    meshes.describe(vertexArray, draws.records(), defaultDetail_);
    materialRecordTexture.upload(
        std::span<const glm::uvec4>(materialRecords(scene.materials, options.workingFromRec709)));
    update();
}

void GpuScene::State::addDraws(const Scene& scene) {
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        if (const std::optional<std::uint32_t> mesh = instances[i].mesh) {
            draws.addMesh(i, scene.meshes[*mesh], meshes.places()[*mesh], scene.materials, images);
            continue;
        }
        const std::uint32_t shape = cages.shown()[instances[i].shown].shape;
        draws.addCage(i, 1 + shape, cages.shape(shape).levels().materials().materials, scene.materials,
                      images);
    }
    draws.finish(instances.size());
}

void GpuScene::State::update() {
    if (moved) place();
    draws.group();
}

void GpuScene::State::place() {
    moved = false;
    const std::vector<glm::mat4> world = worldTransforms(sceneState, time);
    if (hasCages()) cages.pose(sceneState, world, time);
    uploadInstances(world);
    if (!lightsReplaced) lights.set(worldLights(sceneState, world));
}

void GpuScene::State::uploadInstances(const std::vector<glm::mat4>& world) {
    records_.clear();
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const Instance& instance = instances[i];
        const auto setWinding = [&](bool mirrored) {
            draws.setWinding(static_cast<std::uint32_t>(i),
                             mirrored ? DrawList::Winding::mirrored : DrawList::Winding::kept);
        };
        if (instance.mesh) {
            const glm::mat4& m = world[instance.node];
            const MeshPlace& place = meshes.places()[*instance.mesh];
            setWinding(appendInstanceRecord(records_, m));
            instanceSpheres[i] = worldSphere(m, place.center, place.radius);
        } else {
            const GpuCages::Shown& shown = cages.shown()[instance.shown];
            const CageShape& shape = cages.shape(shown.shape);
            setWinding(appendInstanceRecord(records_, shown.worldFromPoints));
            instanceSpheres[i] = worldSphere(shown.worldFromPoints, shape.center(), shape.radius());
        }
    }
    instanceRecords.upload(std::span<const glm::vec4>(records_));
}

void GpuScene::State::updateCages(const CameraView& view, int width, int height) {
    if (!hasCages()) return;
    for (const std::uint32_t shape : cages.update(view, width, height, draws.records())) {
        for (std::uint32_t i = 0; i < instances.size(); ++i) {
            if (!instances[i].mesh && cages.shown()[instances[i].shown].shape == shape)
                draws.setRanges(i, cages.shape(shape).ranges());
        }
    }
}

void GpuScene::State::cull(const Frustum& frustum, DrawSelection& selection) const {
    selection.visible_.resize(instances.size());
    selection.cageInstances_.clear();
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const glm::vec4& sphere = instanceSpheres[i];
        const bool visible = !hidden_[i] && frustum.meets(glm::vec3(sphere), sphere.w);
        selection.visible_[i] = visible ? 1 : 0;
        if (visible && !instances[i].mesh) selection.cageInstances_.push_back(i);
    }
    draws.cull(selection);
}

GLuint GpuScene::State::vertexArrayOf(const DrawBatch& batch) const {
    const std::uint32_t geometry = batch.key.geometry;
    return geometry == 0 ? vertexArray.name() : cages.shape(geometry - 1).vertexArray();
}

std::optional<std::uint32_t> GpuScene::State::levelOf(std::uint32_t instance) const {
    if (instances[instance].mesh) return std::nullopt;
    return cages.shape(cages.shown()[instances[instance].shown].shape).level().value_or(0);
}

void GpuScene::State::appendLines(CageLineKind kind, const DrawSelection& selection,
                                  std::vector<CageLines>& lines) {
    for (const std::uint32_t instance : selection.cageInstances())
        lines.push_back(cages.lines(kind, instances[instance].shown, instance));
}

void GpuScene::State::setCagePoints(std::uint32_t node, std::span<const glm::vec3> points) {
    assert(node < sceneState.nodes.size());
    const ErrorContext element("node", node, sceneState.nodes[node].name);
    const auto instance =
        std::ranges::find_if(instances, [&](const Instance& i) { return i.node == node && !i.mesh; });
    element.require(instance != instances.end(), "shows no cage whose points could be moved");
    const std::size_t count = sceneState.cages[sceneState.nodes[node].cage->cage].positions.size();
    if (points.size() != count) {
        element.refuse("its cage has " + std::to_string(count) + " points, but " +
                       std::to_string(points.size()) + " are given");
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (!allFinite(points[i]))
            element.refuse("point " + std::to_string(i) + " of its cage must be finite numbers");
    }
    cages.setPoints(instance->shown, points);
    draws.setGeometry(static_cast<std::uint32_t>(instance - instances.begin()),
                      1 + cages.shown()[instance->shown].shape);
    moved = true;
}

void GpuScene::State::setMaterial(std::uint32_t index, const Material& material) {
    assert(index < sceneState.materials.size());
    validateMaterial(material, sceneState, ErrorContext("material", index, material.name));
    surfaceUvs.check(index, material);
    draws.setMaterial(index, material, images);
    sceneState.materials[index] = material;
    cages.setMaterials(sceneState.materials);
    const std::vector<glm::uvec4> record = materialRecord(material, options.workingFromRec709);
    const auto bytes = static_cast<GLsizeiptr>(record.size() * sizeof(glm::uvec4));
    glNamedBufferSubData(materialRecordTexture.buffer(), bytes * static_cast<GLsizeiptr>(index), bytes,
                         record.data());
}

void GpuScene::State::setVisibility(std::uint32_t node, Visibility visibility) {
    assert(node < sceneState.nodes.size());
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (instances[i].node != node) continue;
        hidden_[i] = visibility == Visibility::hidden;
        if (!instances[i].mesh) cages.setVisibility(instances[i].shown, visibility);
    }
}

}  // namespace candela
