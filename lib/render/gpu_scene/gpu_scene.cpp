#include "gl/state_guard.h"
#include "render/environment/gpu_environment.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "render/occlusion/occlusion_scene.h"

#include <candela/error.h>

#include <string>
#include <utility>

namespace candela {

GpuScene::GpuScene(const Context& context, const Scene& scene, const GpuSceneOptions& options)
    : GpuScene(context, scene, {}, options) {}

GpuScene GpuScene::takingPixels(const Context& context, Scene& scene, const GpuSceneOptions& options) {
    return {context, scene, scene.images, options};
}

GpuScene::GpuScene(const Context& context, const Scene& scene, std::span<Image> taken,
                   const GpuSceneOptions& options) {
    context.makeCurrent();
    validate(scene);
    const std::shared_ptr<gl::ContextBinding>& binding = context.state().binding;
    // Images are uploaded with the pixel storage that it sets.
    const gl::StateGuard guard(*binding, "a GpuScene");
    state_ = std::shared_ptr<State>(new State(context, scene, taken, options),
                                    gl::ContextDeleter<State>{binding, "GpuScene"});
}

GpuScene::GpuScene(GpuScene&&) noexcept = default;
GpuScene& GpuScene::operator=(GpuScene&&) noexcept = default;
GpuScene::~GpuScene() = default;

GpuScene::State& GpuScene::state() {
    return const_cast<State&>(std::as_const(*this).state());
}

const GpuScene::State& GpuScene::state() const {
    if (!state_) throw Error(ErrorKind::badInput, "", "the GpuScene has been moved from and can not be used");
    return *state_;
}

void GpuScene::requireContext() const {
    state().binding->requireCurrent("a GpuScene");
}

void GpuScene::setLights(std::span<const WorldLight> lights) {
    requireContext();
    state().setLights(lights);
}

void GpuScene::setTransform(NodeHandle node, const glm::mat4& local) {
    state().setTransform(state().nodeSlots.indexOf(node), local);
}

void GpuScene::setTransforms(std::span<const NodeTransform> transforms) {
    state().setTransforms(transforms);
}

void GpuScene::setTime(double seconds) {
    state().setTime(seconds);
}

void GpuScene::keepPoses() {
    requireContext();
    state().keepPoses();
}

void GpuScene::playAnimations(std::span<const std::uint32_t> animations) {
    state().playAnimations(animations);
}

void GpuScene::setCagePoints(NodeHandle node, std::span<const glm::vec3> points) {
    requireContext();
    state().setCagePoints(state().nodeSlots.indexOf(node), points);
}

void GpuScene::setSubdivision(const SubdivisionSettings& settings) {
    state().cages.setSettings(settings);
}

void GpuScene::setMaterial(MaterialHandle handle, const Material& material) {
    requireContext();
    state().setMaterial(state().materialSlots.indexOf(handle), material);
}

void GpuScene::setVisibility(NodeHandle node, Visibility visibility) {
    state().setVisibility(state().nodeSlots.indexOf(node), visibility);
}

void GpuScene::setVisibilities(std::span<const NodeVisibility> visibilities) {
    state().setVisibilities(visibilities);
}

void GpuScene::setCastsShadow(NodeHandle node, ShadowCasting casting) {
    state().setCastsShadow(state().nodeSlots.indexOf(node), casting);
}

void GpuScene::setEnvironment(const std::optional<Environment>& environment) {
    requireContext();
    state().setEnvironment(environment);
}

void GpuScene::setEnvironmentSettings(const EnvironmentSettings& settings) {
    state().setEnvironmentSettings(settings);
}

const LightReport& GpuScene::lightReport() const {
    return state().lights.report();
}

CageReport GpuScene::cageReport() const {
    return state().cages.report();
}

DeformationReport GpuScene::deformationReport() const {
    return state().deformations.report();
}

OcclusionReport GpuScene::occlusionReport() const {
    return state().occlusion ? state().occlusion->report() : OcclusionReport{};
}

std::uint64_t GpuScene::triangleCount() const {
    return elementCount(Topology::triangles);
}

std::uint64_t GpuScene::elementCount(Topology topology) const {
    const auto index = static_cast<std::size_t>(topology);
    if (index >= state().elements.size())
        throw Error(ErrorKind::badInput, "", "there is no topology " + std::to_string(index));
    return state().elements[index];
}

std::uint32_t GpuScene::materialCount() const {
    const Slots& slots = state().materialSlots;
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < slots.size(); ++i) count += slots.isAlive(i) ? 1 : 0;
    return count;
}

}  // namespace candela
