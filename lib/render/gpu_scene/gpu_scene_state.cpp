#include "render/gpu_scene/gpu_scene_state.h"

#include "base/error_context.h"
#include "gl/state_guard.h"
#include "render/culling/compute_triangle_filter.h"
#include "render/culling/cpu_triangle_filter.h"
#include "render/culling/occlusion_culler.h"
#include "render/environment/gpu_environment.h"
#include "render/occlusion/occlusion_scene.h"
#include "scene/geometry/axes.h"
#include "scene/model/animation.h"
#include "scene/model/frame_callback.h"
#include "scene/model/material_textures.h"
#include "scene/validate/scene_rules.h"

#include <candela/error.h>
#include <candela/threads.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace candela {

namespace {

/// Half an octave of depth; from 1 on. Exponent and highest bit of the mantissa of a positive float.
std::uint16_t distanceClass(float depth) {
    return static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(std::max(depth, 1.0e-30f)) >> 22);
}

/// What edits change or need: all but vertices and pixels.
Scene editableParts(const Scene& scene) {
    Scene parts;
    parts.nodes = scene.nodes;
    parts.origin = scene.origin;
    parts.lights = scene.lights;
    parts.animations = scene.animations;
    parts.cages = scene.cages;
    for (Cage& cage : parts.cages) cage.variants.clear();
    parts.skins = scene.skins;
    parts.materials = scene.materials;
    parts.variants = scene.variants;
    parts.frameCallback = scene.frameCallback;
    // Animations of morph weights have as many values as their mesh has targets.
    for (const Mesh& mesh : scene.meshes) {
        parts.meshes.emplace_back().name = mesh.name;
        parts.meshes.back().morphTargets.resize(mesh.morphTargets.size());
    }
    for (const Image& image : scene.images)
        parts.images.push_back({image.name, image.width, image.height, image.format, {}});
    return parts;
}

const GpuSceneOptions& checked(const GpuSceneOptions& options) {
    ErrorContext("GpuSceneOptions")
        .require(options.rangeLoss > 0.0f && options.rangeLoss < 1.0f,
                 "rangeLoss must be over 0 and under 1");
    const glm::dmat3& matrix = options.workingFromRec709;
    if (allFinite(matrix[0]) && allFinite(matrix[1]) && allFinite(matrix[2])) return options;
    throw Error(ErrorKind::badInput, "", "the matrix to the working space must be finite numbers");
}

GpuMeshes::Detail meshDetail(const Scene& scene, const GpuSceneOptions& options) {
    return options.vertexDetail == VertexDetail::always ? GpuMeshes::Detail::everything : detailOf(scene);
}

/// On another thread, where parallel work may have one and there is one to be had.
std::launch besideThisThread() {
    return threadCount() > 1 ? std::launch::async | std::launch::deferred : std::launch::deferred;
}

}  // namespace

void GpuScene::State::requireIndex(const char* kind, std::uint32_t index, std::size_t count) {
    if (index < count) return;
    throw Error(ErrorKind::badInput, "",
                std::string("there is no ") + kind + " " + std::to_string(index) + ": the scene has " +
                    std::to_string(count) + " (counted from 0)");
}

ErrorContext GpuScene::State::nodeContext(std::uint32_t node) const {
    requireIndex("node", node, sceneState.nodes.size());
    return {"node", node, sceneState.nodes[node].name};
}

GpuScene::State::State(const Context& context, const Scene& scene, std::span<Image> taken,
                       const GpuSceneOptions& sceneOptions)
    : binding(context.state().binding),
      options(checked(sceneOptions)),
      sceneState(editableParts(scene)),
      elements{candela::elementCount(scene, Topology::triangles),
               candela::elementCount(scene, Topology::lines), candela::elementCount(scene, Topology::points)},
      nodeSlots("node", scene.nodes.size()),
      meshSlots("mesh", scene.meshes.size()),
      cageSlots("cage", scene.cages.size()),
      materialSlots("material", scene.materials.size()),
      imageSlots("image", scene.images.size()),
      lightSlots("light", scene.lights.size()),
      transforms(sceneState),
      clustersToCome(std::async(besideThisThread(), [&scene] { return MeshClusters(scene.meshes); })),
      meshes(scene.meshes, meshDetail(scene, options),
             context.isSoftware() ? GpuMeshes::Access::deviceAndCpu : GpuMeshes::Access::device),
      clusters(clustersToCome.get()),
      images(scene.images, context.isSoftware() ? ColorDecoding::exact : ColorDecoding::device),
      materials(scene, options.workingFromRec709),
      lights(options.workingFromRec709, context.isSoftware() ? LightUpload::whenBound : LightUpload::atOnce),
      cages(context, sceneState, options),
      deformations(context, scene, sceneState, meshDetail(scene, options), options.vertexEvaluator),
      instances(scene),
      draws(scene.materials.size()),
      materialTracks_(sceneState),
      lightTracks_(sceneState),
      nodeTracks_(sceneState),
      isHidden_(sceneState.nodes.size(), false),
      isVisible_(sceneState.nodes.size(), true) {
    // That of the default material.
    materialSlots.addUnused();
    for (const Mesh& mesh : scene.meshes) meshParts.push_back(partsOf(mesh));
    meshUsers_.resize(scene.meshes.size());
    for (const Node& node : scene.nodes) {
        if (node.mesh) ++meshUsers_[*node.mesh];
    }
    if (!taken.empty()) images.takeSources(taken);
    if (scene.environment) draws.setOcclusionTextures(OcclusionTextures::read, sceneState.materials, images);
    addDraws(scene);
    images.releaseSources();
    describeMeshes(vertexArray);
    if (meshes.hasFurtherUvs()) {
        describeMeshes(furtherUvArray);
        meshes.describeFurtherUvs(furtherUvArray);
    }
    deformations.describe(meshes, draws.records(), defaultDetail_);
    reserveAnimatedLobes();
    update_ = updateOf(0.0);
    transforms.setTime(0.0, update_);
    for (std::uint32_t node = 0; node < sceneState.nodes.size(); ++node) updateVisibility(node);
    update();
    lights.set(worldLights(sceneState, transforms.world()), rangeRule());
    listNodeLights();
    setEnvironment(scene.environment);
    createTriangleFilter(context);
}

GpuScene::State::~State() = default;

void GpuScene::State::createTriangleFilter(const Context& context) {
    if (context.isSoftware()) {
        triangleFilter = std::make_unique<CpuTriangleFilter>(*this);
        occlusionCuller = std::make_unique<OcclusionCuller>(*this);
    } else {
        triangleFilter = std::make_unique<ComputeTriangleFilter>(*this);
    }
}

bool GpuScene::State::hasEnvironmentLight() const {
    return environment && environment->lights();
}

bool GpuScene::State::usesOcclusionTextures() const {
    return hasEnvironmentLight() && std::ranges::any_of(sceneState.materials, [](const Material& material) {
               return material.occlusionTexture && material.occlusionStrength > 0.0f;
           });
}

void GpuScene::State::addDraws(const Scene& scene) {
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        if (const std::optional<std::uint32_t> mesh = instances[i].mesh) {
            addMeshDraws(i, *mesh, scene);
            continue;
        }
        const std::uint32_t surface = cages.instances()[instances[i].cageInstance].surface;
        draws.addCage(i, surface, cages.surface(surface).tables().materials().materials, scene.materials,
                      images);
    }
    draws.placeRecords(instances.inNodeOrder());
}

void GpuScene::State::addMeshDraws(std::uint32_t instance, std::uint32_t mesh, const Scene& scene) {
    DrawGeometry geometry;
    MeshPlace place = meshes.places()[mesh];
    if (const std::optional<std::uint32_t> deformed = deformations.ofNode(instances[instance].node)) {
        geometry = {DrawGeometry::Kind::deformedMesh, *deformed};
        place.baseVertex = 0;
    }
    draws.addMesh(instance, geometry, mesh, meshParts[mesh], place, scene.materials, images);
}

void GpuScene::State::listNodeLights() {
    lightsFollowNodes_ = true;
    nodeLights_.clear();
    for (std::uint32_t i = 0; i < sceneState.lights.size(); ++i) {
        const std::optional<std::uint32_t> node = sceneState.lights[i].node;
        if (!node || !lightSlots.isAlive(i)) continue;
        nodeLights_.resize(sceneState.nodes.size());
        nodeLights_[*node].push_back(i);
    }
}

void GpuScene::State::setTransform(std::uint32_t node, const glm::mat4& local) {
    const ErrorContext context = nodeContext(node);
    context.require(allFinite(local), "its matrix must be finite numbers");
    context.require(isAffine(local), "its matrix must be affine: a last row of 0, 0, 0, 1");
    transforms.setLocal(node, local);
}

void GpuScene::State::setLights(std::span<const WorldLight> worldLights) {
    lights.set(worldLights, rangeRule());
    lightsFollowNodes_ = false;
    lightsEdited_ = false;
    sceneState.lights = {};
    lightSlots.removeAll();
    nodeLights_ = {};
    lightPlaces_ = {};
    lightTracks_.clear();
}

void GpuScene::State::setCagePoints(std::uint32_t node, std::span<const glm::vec3> points) {
    const ErrorContext context = nodeContext(node);
    const std::optional<std::uint32_t> instance = instances.cageOf(node);
    if (!instance) context.refuse("shows no cage whose points could be moved");
    const std::size_t count = sceneState.cages[*sceneState.nodes[node].cage].positions.size();
    if (points.size() != count) {
        context.refuse("its cage has " + std::to_string(count) + " points, but " +
                       std::to_string(points.size()) + " are given");
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (!allFinite(points[i]))
            context.refuse("point " + std::to_string(i) + " of its cage must be finite numbers");
    }
    const std::uint32_t cageInstance = instances[*instance].cageInstance;
    cages.setPoints(cageInstance, points);
    draws.setSurface(*instance, cages.instances()[cageInstance].surface);
}

void GpuScene::State::setCastsShadow(std::uint32_t node, ShadowCasting casting) {
    requireIndex("node", node, sceneState.nodes.size());
    sceneState.nodes[node].castsShadow = casting == ShadowCasting::on;
    if (const std::optional<std::uint32_t> mesh = instances.meshOf(node)) instances.markChanged(*mesh);
    if (const std::optional<std::uint32_t> cage = instances.cageOf(node)) instances.markChanged(*cage);
}

void GpuScene::State::setEnvironment(const std::optional<Environment>& given) {
    if (!given) {
        environment.reset();
        return;
    }
    validateEnvironment(*given);
    const gl::StateGuard pixelStorage(*binding, "a GpuScene");
    auto made = std::make_unique<GpuEnvironment>(*given, options.workingFromRec709);
    draws.setOcclusionTextures(OcclusionTextures::read, sceneState.materials, images);
    environment = std::move(made);
}

void GpuScene::State::setEnvironmentSettings(const EnvironmentSettings& settings) {
    const ErrorContext element("environment");
    if (!environment) element.refuse("the scene has none whose settings could be changed");
    validateEnvironmentSettings(settings, environment->largestRadiance(), element);
    environment->set(settings);
}

void GpuScene::State::update() {
    lastUpdate = {};
    const std::span<const std::uint32_t> moved = transforms.update();
    if (timeChanged_) {
        cages.markAnimated();
        deformations.markAnimated();
        takeUpdate();
        poseProperties();
    }
    timeChanged_ = false;
    for (const std::uint32_t node : moved) moveNode(node);
    const std::span<const std::uint32_t> posed = cages.pose(transforms.world(), transforms.time());
    for (const std::uint32_t cageInstance : posed) placeCage(cageInstance);
    const std::span<const std::uint32_t> deformed = deformations.pose(transforms.world(), transforms.time());
    for (const std::uint32_t index : deformed) placeDeformed(index);
    lastUpdate.deformations = deformed.size();
    if (lightsEdited_) resetLights();
    const bool changed =
        !moved.empty() || !posed.empty() || !deformed.empty() || rangeRuleChanged_ || lights.rangelessMoved();
    if (lights.hasRangeless() && changed) updateRanges();
    rangeRuleChanged_ = false;
    lastUpdate.nodes = moved.size();
    lastUpdate.cages = posed.size();
    lastUpdate.instances = instances.upload();
    lastUpdate.lights = lights.upload();
    lastUpdate.materials = materials.upload();
    if (draws.isUnplaced()) draws.placeRecords(instances.inNodeOrder());
    lastUpdate.draws = draws.group();
}

void GpuScene::State::keepPoses() {
    update();
    instances.keep();
    deformations.keep();
    cages.keep();
    kept_ = update_;
}

const SceneUpdate::MeshVertices* GpuScene::State::keptVertices(std::uint32_t mesh) const {
    return kept_ && kept_ != update_ ? kept_->ofMesh(mesh) : nullptr;
}

void GpuScene::State::moveNode(std::uint32_t node) {
    const std::optional<std::uint32_t> mesh = instances.meshOf(node);
    if (mesh && !deformations.ofNode(node))
        place(*mesh, transforms.world()[node], meshes.places()[*instances[*mesh].mesh].sphere);
    cages.markNode(node);
    deformations.markNode(node);
    if (!lightsFollowNodes_ || lightsEdited_ || node >= nodeLights_.size()) return;
    for (const std::uint32_t light : nodeLights_[node])
        lights.move(lightPlace(light), worldLight(sceneState.lights[light], transforms.world()));
}

void GpuScene::State::placeCage(std::uint32_t cageInstance) {
    const GpuCages::Instance& cage = cages.instances()[cageInstance];
    place(*instances.cageOf(cage.node), cage.worldFromPoints, cages.surface(cage.surface).sphere());
}

void GpuScene::State::placeDeformed(std::uint32_t index) {
    const GpuDeformations::Placement& deformed = deformations.placement(index);
    place(*instances.meshOf(deformed.node), deformed.worldFromLocal, deformed.sphere, deformed.winding);
}

void GpuScene::State::place(std::uint32_t instance, const glm::mat4& worldFromLocal,
                            const BoundingSphere& sphere, std::optional<Winding> winding) {
    const Winding last = instances.winding(instance);
    instances.place(instance, worldFromLocal, sphere, winding);
    if (instances.winding(instance) != last) draws.setWinding(instance, instances.winding(instance));
}

void GpuScene::State::updateCages(const CameraView& view, int width, int height, VertexScope scope) {
    if (!hasCages()) return;
    for (const std::uint32_t surface : cages.update({view, width, height}, scope, draws.records())) {
        for (const std::uint32_t cageInstance : cages.instancesOf(surface)) {
            const std::uint32_t node = cages.instances()[cageInstance].node;
            draws.setRanges(*instances.cageOf(node), cages.surface(surface).ranges());
        }
    }
}

void GpuScene::State::updateDeformations(const Frustum& frustum, VertexScope scope) {
    stale_.clear();
    for (std::uint32_t i = 0; i < deformations.size(); ++i) {
        if (deformations.isFree(i)) continue;
        const std::uint32_t instance = *instances.meshOf(deformations.placement(i).node);
        const bool needed = scope == VertexScope::everywhere || instances.isVisible(instance, frustum);
        if (deformations.isStale(i) && needed) stale_.push_back(i);
    }
    lastUpdate.deformed = stale_.size();
    if (!stale_.empty()) deformations.deform(stale_);
}

void GpuScene::State::describeMeshes(const gl::VertexArray& array) const {
    meshes.describe(array, draws.records(), defaultDetail_);
}

void GpuScene::State::updateOcclusion() {
    if (!occlusion) occlusion = std::make_unique<OcclusionScene>();
    occlusion->update(*this);
}

/// Sets the distances of all instances, and lists those in view.
void GpuScene::State::selectVisible(const Frustum& frustum, DrawSelection& selection) const {
    selection.distances_.resize(instances.size());
    selection.cageInstances_.clear();
    selection.meshInstances_.clear();
    selection.occluded_.clear();
    selection.hiddenTriangles_.clear();
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const bool visible = instances.isVisible(i, frustum);
        selection.distances_[i] =
            visible ? distanceClass(instances.farthestDepth(i, frustum)) : DrawSelection::hidden;
        if (visible) (instances[i].mesh ? selection.meshInstances_ : selection.cageInstances_).push_back(i);
    }
}

void GpuScene::State::cull(const Frustum& frustum, DrawSelection& selection) const {
    selectVisible(frustum, selection);
    draws.cull(selection);
}

void GpuScene::State::cullOccluded(const Frustum& frustum, const layout::FrameUniforms& frame,
                                   DrawSelection& selection) const {
    selectVisible(frustum, selection);
    if (occlusionCuller) {
        const OcclusionCuller::Hidden hidden = occlusionCuller->findHidden(frame, selection.meshInstances_);
        selection.occluded_.assign(hidden.instances.begin(), hidden.instances.end());
        selection.hiddenTriangles_.assign(hidden.triangles.begin(), hidden.triangles.end());
    }
    draws.cull(selection);
}

GLuint GpuScene::State::vertexArrayOf(const PipelineKey& key) const {
    const auto [kind, index] = key.geometry;
    switch (kind) {
        case DrawGeometry::Kind::deformedMesh:
            return deformations.vertexArray(index);
        case DrawGeometry::Kind::cage:
            return cages.surface(index).vertexArray();
        default:
            return key.furtherUvPairs == 0 ? vertexArray.name() : furtherUvArray.name();
    }
}

std::optional<std::uint32_t> GpuScene::State::levelOf(std::uint32_t instance) const {
    if (instances[instance].mesh) return std::nullopt;
    return cages.surface(cages.instances()[instances[instance].cageInstance].surface).level().value_or(0);
}

void GpuScene::State::appendLines(CageLineKind kind, const DrawSelection& selection,
                                  std::vector<CageLines>& lines) {
    for (const std::uint32_t instance : selection.cageInstances())
        lines.push_back(cages.lines(kind, instances[instance].cageInstance, instance));
}

}  // namespace candela
