#include "render/subdivision/gpu_cages.h"

#include "scene/model/deformation.h"
#include "scene/model/frame_callback.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candela {

namespace {

bool sameView(const CameraView& a, const CameraView& b) {
    return a.worldFromCamera == b.worldFromCamera && a.verticalFov == b.verticalFov &&
           a.orthographicHeight == b.orthographicHeight && a.nearPlane == b.nearPlane && a.shift == b.shift &&
           a.aspect == b.aspect;
}

}  // namespace

GpuCages::GpuCages(const Context& context, const Scene& scene, const GpuSceneOptions& options)
    : scene_(scene),
      subdivider_(options.subdivider),
      noMaterial_(static_cast<std::uint32_t>(scene.materials.size())),
      settings_(options.subdivision),
      subdivided_(options.subdivider.has_value()),
      evaluator_(context, options.vertexEvaluator) {
    checkSettings(settings_);
    // A cage that the subdivider rejects fails the upload.
    for (const Cage& cage : scene.cages) tables_.push_back(makeTables(cage));
    sharedSurfaces_.resize(tables_.size());
    for (const Material& material : scene.materials)
        hasNormalTexture_.push_back(material.normalTexture.has_value());
    addInstances();
    if (empty()) return;
    listJoints();
    listAnimated();
    for (const auto& surface : surfaces_) setTangents(*surface);
}

void GpuCages::addInstances() {
    for (std::uint32_t i = 0; i < scene_.nodes.size(); ++i) {
        const std::optional<std::uint32_t> cage = scene_.nodes[i].cage;
        if (!cage) continue;
        Instance instance{.node = i, .cage = *cage};
        instance.isDeformed =
            candela::isDeformed(scene_.nodes[i], scene_.cages[*cage]) || movesCage(scene_, *cage);
        std::optional<std::uint32_t>& shared = sharedSurfaces_[*cage];
        if (!instance.isDeformed && !shared) shared = addSurface(*cage);
        instance.surface = instance.isDeformed ? addSurface(*cage) : *shared;
        users_[instance.surface].push_back(static_cast<std::uint32_t>(instances_.size()));
        instances_.push_back(instance);
    }
}

void GpuCages::listJoints() {
    instancesOfNode_.resize(scene_.nodes.size());
    for (std::uint32_t i = 0; i < instances_.size(); ++i) {
        const std::uint32_t node = instances_[i].node;
        instancesOfNode_[node].push_back(i);
        if (!isSkinned(scene_.nodes[node], scene_.cages[instances_[i].cage])) continue;
        for (const std::uint32_t joint : scene_.skins[*scene_.nodes[node].skin].joints)
            instancesOfNode_[joint].push_back(i);
    }
}

void GpuCages::listAnimated() {
    std::vector<bool> isAnimated(scene_.nodes.size());
    for (const Animation& animation : scene_.animations) {
        for (const AnimationChannel& channel : animation.channels) {
            if (channel.path == AnimationPath::morphWeights) isAnimated[channel.node] = true;
        }
    }
    for (std::uint32_t i = 0; i < instances_.size(); ++i) {
        if (isAnimated[instances_[i].node] || movesCage(scene_, instances_[i].cage)) animated_.push_back(i);
    }
}

std::uint32_t GpuCages::firstLevel(const CageTables& tables) const {
    return tables.fixedLevel(settings_).value_or(1);
}

std::uint32_t GpuCages::addSurface(std::uint32_t cage) {
    CageTables& tables = *tables_[cage];
    surfaces_.push_back(std::make_unique<LimitSurface>(tables, firstLevel(tables)));
    users_.emplace_back();
    requests_.emplace_back();
    return static_cast<std::uint32_t>(surfaces_.size() - 1);
}

std::unique_ptr<CageTables> GpuCages::makeTables(const Cage& cage) const {
    auto tables = std::make_unique<CageTables>(cage, subdivider_, noMaterial_);
    tables->table(firstLevel(*tables));
    return tables;
}

void GpuCages::setTables(std::uint32_t cage, std::unique_ptr<CageTables> tables) {
    if (cage >= tables_.size()) {
        tables_.resize(cage + 1);
        sharedSurfaces_.resize(cage + 1);
    }
    if (const std::optional<std::uint32_t> shared = std::exchange(sharedSurfaces_[cage], std::nullopt))
        surfaces_[*shared].reset();
    tables_[cage] = std::move(tables);
    view_.reset();
}

std::uint32_t GpuCages::addInstance(std::uint32_t node) {
    Instance instance{.node = node, .cage = *scene_.nodes[node].cage};
    instance.isDeformed = movesCage(scene_, instance.cage);
    std::optional<std::uint32_t> surface = sharedSurfaces_[instance.cage];
    if (!surface || instance.isDeformed) {
        surface = addSurface(instance.cage);
        setTangents(*surfaces_[*surface]);
        if (!instance.isDeformed) sharedSurfaces_[instance.cage] = surface;
    }
    instance.surface = *surface;
    auto index = static_cast<std::uint32_t>(instances_.size());
    if (freeInstances_.empty()) {
        instances_.emplace_back();
    } else {
        index = freeInstances_.back();
        freeInstances_.pop_back();
    }
    instances_[index] = instance;
    if (instance.isDeformed) animated_.push_back(index);
    users_[instance.surface].push_back(index);
    if (node >= instancesOfNode_.size()) instancesOfNode_.resize(scene_.nodes.size());
    instancesOfNode_[node].push_back(index);
    mark(index);
    return index;
}

void GpuCages::removeInstance(std::uint32_t index) {
    Instance& instance = instances_[index];
    leaveSurface(index);
    // Joints that have moved it may still list it.
    std::erase(instancesOfNode_[instance.node], index);
    std::erase(animated_, index);
    std::erase(marked_, index);
    instance = {};
    instance.isRemoved = instance.hidden = true;
    freeInstances_.push_back(index);
    view_.reset();
}

/// A surface that no instance shows any more is freed, unless later instances may share it.
void GpuCages::leaveSurface(std::uint32_t index) {
    const Instance& instance = instances_[index];
    std::erase(users_[instance.surface], index);
    if (users_[instance.surface].empty() && sharedSurfaces_[instance.cage] != instance.surface)
        surfaces_[instance.surface].reset();
}

void GpuCages::mark(std::uint32_t instance) {
    if (instances_[instance].isMarked || instances_[instance].isRemoved) return;
    instances_[instance].isMarked = true;
    marked_.push_back(instance);
}

void GpuCages::markNode(std::uint32_t node) {
    if (node >= instancesOfNode_.size()) return;
    for (const std::uint32_t instance : instancesOfNode_[node]) mark(instance);
}

void GpuCages::markAnimated() {
    for (const std::uint32_t instance : animated_) mark(instance);
}

std::span<const std::uint32_t> GpuCages::pose(const std::vector<glm::mat4>& world, double time) {
    posed_.swap(marked_);
    marked_.clear();
    for (const std::uint32_t index : posed_) {
        Instance& instance = instances_[index];
        instance.isMarked = false;
        if (!instance.isDeformed) {
            instance.worldFromPoints = world[instance.node];
            continue;
        }
        const PosedPoints posed = poseCage(scene_, instance.node, world, time);
        instance.worldFromPoints = posed.worldFromPoints;
        surfaces_[instance.surface]->setPoints(posed.points);
    }
    if (!posed_.empty()) view_.reset();
    return posed_;
}

void GpuCages::setPoints(std::uint32_t index, std::span<const glm::vec3> points) {
    Instance& instance = instances_[index];
    if (users_[instance.surface].size() > 1) {
        const std::uint32_t own = addSurface(instance.cage);
        std::erase(users_[instance.surface], index);
        users_[own].push_back(index);
        instance.surface = own;
        setTangents(*surfaces_[own]);
    } else if (sharedSurfaces_[instance.cage] == instance.surface) {
        sharedSurfaces_[instance.cage].reset();
    }
    instance.isDeformed = false;
    surfaces_[instance.surface]->setPoints(points);
    mark(index);
}

void GpuCages::setVisibility(std::uint32_t instance, GpuScene::Visibility visibility) {
    instances_[instance].hidden = visibility == GpuScene::Visibility::hidden;
    view_.reset();
}

void GpuCages::setSettings(const SubdivisionSettings& settings) {
    checkSettings(settings);
    settings_ = settings;
    view_.reset();
}

void GpuCages::setMaterial(std::uint32_t index, const Material& material) {
    if (index >= hasNormalTexture_.size()) hasNormalTexture_.resize(index + 1, false);
    if (hasNormalTexture_[index] == material.normalTexture.has_value()) return;
    hasNormalTexture_[index] = material.normalTexture.has_value();
    for (const auto& surface : surfaces_) {
        if (surface) setTangents(*surface);
    }
}

bool GpuCages::isNeeded(std::uint32_t surface, VertexScope scope) const {
    if (users_[surface].empty()) return false;
    return scope == VertexScope::everywhere || requests_[surface].inView;
}

void GpuCages::setTangents(LimitSurface& surface) const {
    const bool needed = std::ranges::any_of(surface.tables().materials().materials, [&](std::uint32_t i) {
        return i < hasNormalTexture_.size() && hasNormalTexture_[i];
    });
    surface.setTangents(needed ? LimitSurface::Tangents::needed : LimitSurface::Tangents::none);
}

std::span<const std::uint32_t> GpuCages::update(const View& view, VertexScope scope,
                                                const gl::Buffer& drawRecords) {
    const bool known = view_ && sameView(view_->camera, view.camera) && view_->width == view.width &&
                       view_->height == view.height;
    if (!known) requestLevels(view);
    releveled_.clear();
    for (std::uint32_t i = 0; i < surfaces_.size(); ++i) {
        if (isNeeded(i, scope) && surfaces_[i]->setLevel(levelFor(i), drawRecords, defaultDetail_))
            releveled_.push_back(i);
    }
    evaluateStale(scope);
    return releveled_;
}

void GpuCages::requestLevels(const View& view) {
    const LodView lod = lodView(view.camera, view.width, view.height);
    std::ranges::fill(requests_, LodRequest{});
    for (const Instance& instance : instances_) {
        if (!instance.hidden) requestLevel(lod, instance);
    }
    view_ = view;
}

void GpuCages::requestLevel(const LodView& view, const Instance& instance) {
    const LimitSurface& surface = *surfaces_[instance.surface];
    const glm::mat4& m = instance.worldFromPoints;
    const auto [center, radius] = worldSphere(m, surface.sphere());
    if (!view.frustum.meets(center, radius)) return;
    LodRequest& request = requests_[instance.surface];
    request.inView = true;
    if (surface.tables().fixedLevel(settings_)) return;
    // No edge is longer than the sphere is wide, nor nearer than its surface.
    const float nearest = glm::distance(center, view.eye) - radius;
    if (request.longestEdge && view.pixels(2.0f * radius, nearest) <= *request.longestEdge) return;
    worldPoints_.clear();
    for (const glm::vec3& point : surface.points()) worldPoints_.emplace_back(m * glm::vec4(point, 1.0f));
    const std::optional<float> longest = longestEdge(view, worldPoints_, surface.tables().edges());
    if (longest) request.longestEdge = std::max(*longest, request.longestEdge.value_or(0.0f));
}

std::uint32_t GpuCages::levelFor(std::uint32_t index) const {
    const LimitSurface& surface = *surfaces_[index];
    if (const std::optional<std::uint32_t> fixed = surface.tables().fixedLevel(settings_)) return *fixed;
    const std::uint32_t maxLevel = surface.tables().maxLevel(settings_);
    const std::optional<float> longest = requests_[index].longestEdge;
    // Without an edge in view the level stays.
    if (!longest) return std::min(surface.level().value_or(1), maxLevel);
    return nextLevel(surface.level(), idealLevel(*longest, settings_.edgePixels), maxLevel);
}

void GpuCages::evaluateStale(VertexScope scope) {
    for (std::uint32_t i = 0; i < surfaces_.size(); ++i) {
        if (isNeeded(i, scope) && surfaces_[i]->isStale()) surfaces_[i]->evaluate(evaluator_);
    }
}

void GpuCages::keep() {
    for (Instance& instance : instances_) {
        instance.keptPoints.clear();
        if (instance.isRemoved || sharedSurfaces_[instance.cage] == instance.surface) continue;
        const std::span<const glm::vec3> points = surfaces_[instance.surface]->points();
        instance.keptPoints.assign(points.begin(), points.end());
    }
}

std::vector<glm::vec3> GpuCages::keptPositions(std::uint32_t index) {
    const Instance& instance = instances_[index];
    const LimitSurface& surface = *surfaces_[instance.surface];
    const std::vector<glm::vec3>& rest = scene_.cages[instance.cage].positions;
    const std::span<const glm::vec3> kept(instance.keptPoints.empty() ? rest : instance.keptPoints);
    if (std::ranges::equal(kept, surface.points())) return {};
    return surface.positionsAt(kept, evaluator_);
}

CageLines GpuCages::lines(CageLineKind kind, std::uint32_t cageInstance, std::uint32_t instance) {
    return surfaces_[instances_[cageInstance].surface]->lines(kind, instance);
}

bool GpuCages::isLodClamped(std::uint32_t index) const {
    const CageTables& tables = surfaces_[index]->tables();
    const std::optional<float> longest = requests_[index].longestEdge;
    if (!longest || tables.fixedLevel(settings_)) return false;
    return idealLevel(*longest, settings_.edgePixels) > static_cast<float>(tables.maxLevel(settings_));
}

CageReport GpuCages::report() const {
    CageReport report;
    report.cages = instances_.size() - freeInstances_.size();
    report.subdivided = subdivided_;
    for (const Instance& instance : instances_) {
        if (instance.isRemoved) continue;
        report.triangles += surfaces_[instance.surface]->triangles();
        report.lodClamped += isLodClamped(instance.surface) ? 1 : 0;
    }
    for (const auto& tables : tables_) report.tableBytes += tables ? tables->tableBytes() : 0;
    bool any = false;
    for (const auto& surface : surfaces_) {
        if (!surface || !surface->level()) continue;
        report.minLevel = any ? std::min(report.minLevel, *surface->level()) : *surface->level();
        report.maxLevel = std::max(report.maxLevel, *surface->level());
        any = true;
    }
    if (evaluator_.lastUsed() != VertexEvaluator::automatic)
        report.evaluator = toString(evaluator_.lastUsed());
    return report;
}

}  // namespace candela
