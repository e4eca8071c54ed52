#include "gl/state_guard.h"
#include "render/gpu_scene/gpu_scene_state.h"

#include <cassert>

namespace candela {

GpuScene::GpuScene(const Context& context, const Scene& scene, const GpuSceneOptions& options) {
    context.makeCurrent();
    validate(scene);
    const std::shared_ptr<gl::ContextBinding>& binding = context.state().binding;
    const gl::StateGuard guard(*binding, "a GpuScene");  // Images are uploaded with the pixel storage that it sets.
    state_ = std::shared_ptr<State>(new State(context, scene, options),
                                    gl::ContextDeleter<State>{binding, "GpuScene"});
}

GpuScene::GpuScene(GpuScene&&) noexcept = default;
GpuScene& GpuScene::operator=(GpuScene&&) noexcept = default;
GpuScene::~GpuScene() = default;

void GpuScene::setLights(std::span<const WorldLight> lights) {
    state_->lights.set(lights);
    state_->lightsReplaced = true;
}

void GpuScene::setTransform(std::uint32_t node, const glm::mat4& local) {
    assert(node < state_->sceneState.nodes.size());
    state_->sceneState.nodes[node].transform = local;
    state_->moved = true;
}

void GpuScene::setTime(double seconds) {
    if (seconds == state_->time || state_->sceneState.animations.empty()) return;
    state_->time = seconds;
    state_->moved = true;
}

void GpuScene::setCagePoints(std::uint32_t node, std::span<const glm::vec3> points) {
    state_->setCagePoints(node, points);
}

void GpuScene::setSubdivision(const SubdivisionSettings& settings) {
    state_->cages.setSettings(settings);
}

void GpuScene::setMaterial(std::uint32_t index, const Material& material) {
    const gl::StateGuard guard(*state_->binding, "a GpuScene");  // As above.
    state_->setMaterial(index, material);
}

void GpuScene::setVisibility(std::uint32_t node, Visibility visibility) {
    state_->setVisibility(node, visibility);
}

CageReport GpuScene::cageReport() const {
    return state_->cages.report();
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
