#include "gl/state_guard.h"
#include "render/gpu_scene_state.h"
#include "render/layout.h"
#include "render/material_records.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace candela {

namespace {

std::vector<Instance> instancesOf(const Scene& scene) {
    std::vector<Instance> instances;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        if (scene.nodes[i].mesh) instances.push_back({i, *scene.nodes[i].mesh});
    }
    return instances;
}

Scene movingParts(const Scene& scene) {
    Scene parts;
    parts.nodes = scene.nodes;
    parts.lights = scene.lights;
    parts.animations = scene.animations;
    return parts;
}

struct NormalMatrix {
    glm::mat3 matrix;
    bool mirrored;  ///< The instance's matrix turns the winding round.
};

/// The matrix that takes normals to the world: the cofactors of the linear part, which are det(M) times the
/// inverse transpose and defined for singular matrices too. The sign is that of the inverse transpose, so
/// that normals of mirrored instances point outwards; the largest element is brought to 1, so that lengths of
/// normals neither overflow nor vanish, however large or small the instance is.
NormalMatrix normalMatrix(const glm::mat4& m) {
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    const bool mirrored = glm::dot(x, cofactors[0]) < 0.0;
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(cofactors[column][row]));
    }
    if (largest == 0.0) return {glm::mat3(0.0f), mirrored};
    return {glm::mat3(cofactors * ((mirrored ? -1.0 : 1.0) / largest)), mirrored};
}

float largestScale(const glm::mat4& m) {
    // The Frobenius norm bounds the largest singular value, sheared matrices included.
    const glm::vec3 x(m[0]), y(m[1]), z(m[2]);
    return std::sqrt(glm::dot(x, x) + glm::dot(y, y) + glm::dot(z, z));
}

}  // namespace

GpuScene::State::State(const Scene& scene, const GpuSceneOptions& sceneOptions)
    : options(sceneOptions),
      skeleton(movingParts(scene)),
      triangles(candela::triangleCount(scene)),
      materialCount(static_cast<std::uint32_t>(scene.materials.size())),
      instances(instancesOf(scene)),
      instanceSpheres(instances.size()),
      meshes(scene.meshes, detailOf(scene)),
      images(scene.images),
      lights(sceneOptions),
      instanceRecords(GL_RGBA32F, "instances"),
      materialRecordTexture(GL_RGBA32UI, "materials"),
      draws(scene, instances, meshes, images),
      vertexArray("scene") {
    meshes.describe(vertexArray, draws.draws());
    materialRecordTexture.upload(
        std::span<const glm::uvec4>(materialRecords(scene.materials, options.workingFromRec709)));
    update();
}

void GpuScene::State::update() {
    if (!moved) return;
    moved = false;
    const std::vector<glm::mat4> world = worldTransforms(skeleton, time);
    uploadInstances(world);
    if (!lightsReplaced) lights.set(placeLights(skeleton, world));
}

void GpuScene::State::uploadInstances(const std::vector<glm::mat4>& world) {
    records_.clear();
    std::vector<bool> mirrored;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const glm::mat4& m = world[instances[i].node];
        const glm::mat4 rows = glm::transpose(m);
        const NormalMatrix normals = normalMatrix(m);
        const glm::mat3 normalRows = glm::transpose(normals.matrix);
        for (int row = 0; row < 3; ++row) records_.push_back(rows[row]);
        const float handedness = normals.mirrored ? -1.0f : 1.0f;
        for (int row = 0; row < 3; ++row) records_.emplace_back(normalRows[row], handedness);
        mirrored.push_back(normals.mirrored);
        const MeshPlace& place = meshes.places()[instances[i].mesh];
        const glm::vec3 center(m * glm::vec4(place.center, 1.0f));
        instanceSpheres[i] = glm::vec4(center, place.radius * largestScale(m));
    }
    instanceRecords.upload(std::span<const glm::vec4>(records_));
    if (mirrored != mirrored_) {
        mirrored_ = std::move(mirrored);
        draws.setMirrored(mirrored_);
    }
}

void GpuScene::State::select(const Frustum& frustum) {
    draws.select([&](std::uint32_t instance) {
        const glm::vec4& sphere = instanceSpheres[instance];
        return frustum.meets(glm::vec3(sphere), sphere.w);
    });
}

GpuScene::GpuScene(const Context& context, const Scene& scene, const GpuSceneOptions& options) {
    context.makeCurrent();
    validate(scene);
    const gl::StateGuard guard;  // Images are uploaded with the pixel storage that it sets.
    state_ = std::make_unique<State>(scene, options);
}

GpuScene::GpuScene(GpuScene&&) noexcept = default;
GpuScene& GpuScene::operator=(GpuScene&&) noexcept = default;
GpuScene::~GpuScene() = default;

void GpuScene::setLights(std::span<const PlacedLight> lights) {
    state_->lights.set(lights);
    state_->lightsReplaced = true;
}

void GpuScene::setTransform(std::uint32_t node, const glm::mat4& local) {
    assert(node < state_->skeleton.nodes.size());
    state_->skeleton.nodes[node].transform = local;
    state_->moved = true;
}

void GpuScene::setTime(double seconds) {
    if (seconds == state_->time || state_->skeleton.animations.empty()) return;
    state_->time = seconds;
    state_->moved = true;
}

const LightReport& GpuScene::lightReport() const {
    return state_->lights.report();
}
std::uint64_t GpuScene::triangleCount() const {
    return state_->triangles;
}
std::uint32_t GpuScene::materialCount() const {
    return state_->materialCount;
}

}  // namespace candela
