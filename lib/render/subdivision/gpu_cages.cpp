#include "render/subdivision/gpu_cages.h"

#include "render/gpu_scene/instance_records.h"
#include "render/subdivision/lod_request.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

bool sameView(const CameraView& a, const CameraView& b) {
    return a.worldFromCamera == b.worldFromCamera && a.verticalFov == b.verticalFov &&
           a.nearPlane == b.nearPlane;
}

bool movesPoints(const CageInstance& shown, const Cage& cage) {
    return shown.skin.has_value() || !cage.morphTargets.empty();
}

}  // namespace

GpuCages::GpuCages(const Context& context, const Scene& scene, const GpuSceneOptions& options)
    : settings_(options.subdivision), subdivided_(options.subdivider.has_value()), evaluator_(context) {
    checkSettings(settings_);
    const auto noMaterial = static_cast<std::uint32_t>(scene.materials.size());
    levels_.reserve(scene.cages.size());
    for (const Cage& cage : scene.cages) {
        CageLevels& levels = levels_.emplace_back(cage, options.subdivider, noMaterial);
        // What the subdivider rejects has to come to light now.
        levels.table(firstLevel(levels));
    }
    std::vector<std::optional<std::uint32_t>> shared(scene.cages.size());
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        const std::optional<CageInstance>& shown = scene.nodes[i].cage;
        if (!shown) continue;
        std::optional<std::uint32_t>& rigid = shared[shown->cage];
        const bool moves = movesPoints(*shown, scene.cages[shown->cage]);
        if (!moves && !rigid) rigid = addShape(shown->cage);
        shown_.push_back({.node = i, .cage = shown->cage, .shape = moves ? addShape(shown->cage) : *rigid});
    }
    setMaterials(scene.materials);
}

std::uint32_t GpuCages::firstLevel(const CageLevels& levels) const {
    return levels.fixedLevel(settings_).value_or(1);
}

std::uint32_t GpuCages::addShape(std::uint32_t cage) {
    CageLevels& levels = levels_[cage];
    shapes_.push_back(std::make_unique<CageShape>(levels, firstLevel(levels)));
    requests_.emplace_back();
    return static_cast<std::uint32_t>(shapes_.size() - 1);
}

void GpuCages::pose(const Scene& scene, const std::vector<glm::mat4>& world, double time) {
    for (Shown& shown : shown_) {
        const CageInstance& cage = *scene.nodes[shown.node].cage;
        if (shown.placed || !movesPoints(cage, scene.cages[cage.cage])) {
            shown.worldFromPoints = world[shown.node];
            continue;
        }
        const PosedCage posed = poseCage(scene, shown.node, world, time);
        shown.worldFromPoints = posed.worldFromPoints;
        shapes_[shown.shape]->move(posed.points);
    }
    picture_.reset();
}

void GpuCages::setPoints(std::uint32_t index, std::span<const glm::vec3> points) {
    Shown& shown = shown_[index];
    if (std::ranges::count(shown_, shown.shape, &Shown::shape) > 1) {
        shown.shape = addShape(shown.cage);
        setTangents(*shapes_.back());
    }
    shown.placed = true;
    shapes_[shown.shape]->move(points);
}

void GpuCages::setVisibility(std::uint32_t index, GpuScene::Visibility visibility) {
    shown_[index].hidden = visibility == GpuScene::Visibility::hidden;
    picture_.reset();
}

void GpuCages::setSettings(const SubdivisionSettings& settings) {
    checkSettings(settings);
    settings_ = settings;
    picture_.reset();
}

void GpuCages::setMaterials(std::span<const Material> materials) {
    hasNormalTexture_.clear();
    for (const Material& material : materials)
        hasNormalTexture_.push_back(material.normalTexture.has_value());
    for (const auto& shape : shapes_) setTangents(*shape);
}

void GpuCages::setTangents(CageShape& shape) const {
    const bool wanted = std::ranges::any_of(shape.levels().materials().materials, [&](std::uint32_t i) {
        return i < hasNormalTexture_.size() && hasNormalTexture_[i];
    });
    shape.setTangents(wanted ? CageShape::Tangents::wanted : CageShape::Tangents::none);
}

std::span<const std::uint32_t> GpuCages::update(const CameraView& view, int width, int height,
                                                const gl::Buffer& drawRecords) {
    const bool known =
        picture_ && sameView(picture_->view, view) && picture_->width == width && picture_->height == height;
    if (!known) look({view, width, height});
    relevelled_.clear();
    for (std::uint32_t i = 0; i < shapes_.size(); ++i) {
        if (requests_[i].inView && shapes_[i]->setLevel(levelFor(i), drawRecords, defaultDetail_))
            relevelled_.push_back(i);
    }
    evaluateStale();
    return relevelled_;
}

void GpuCages::look(const Picture& picture) {
    const Sight sight = sightOf(picture.view, picture.width, picture.height);
    std::ranges::fill(requests_, LodRequest{});
    for (const Shown& shown : shown_) {
        if (!shown.hidden) lookAtShown(sight, shown);
    }
    picture_ = picture;
}

void GpuCages::lookAtShown(const Sight& sight, const Shown& shown) {
    const CageShape& shape = *shapes_[shown.shape];
    const glm::mat4& m = shown.worldFromPoints;
    const glm::vec4 sphere = worldSphere(m, shape.center(), shape.radius());
    const glm::vec3 center(sphere);
    const float radius = sphere.w;
    if (!sight.frustum.meets(center, radius)) return;
    LodRequest& request = requests_[shown.shape];
    request.inView = true;
    if (shape.levels().fixedLevel(settings_)) return;
    // No edge is longer than the sphere is wide, nor nearer than its surface.
    const float nearest = std::max(glm::distance(center, sight.eye) - radius, sight.nearPlane);
    if (request.longestEdge && 2.0f * radius * sight.pixelsAtOneMetre / nearest <= *request.longestEdge)
        return;
    worldPoints_.clear();
    for (const glm::vec3& point : shape.points()) worldPoints_.emplace_back(m * glm::vec4(point, 1.0f));
    const std::optional<float> longest = longestEdge(sight, worldPoints_, shape.levels().edges());
    if (longest) request.longestEdge = std::max(*longest, request.longestEdge.value_or(0.0f));
}

std::uint32_t GpuCages::levelFor(std::uint32_t index) const {
    const CageShape& shape = *shapes_[index];
    if (const std::optional<std::uint32_t> fixed = shape.levels().fixedLevel(settings_)) return *fixed;
    const std::uint32_t greatest = shape.levels().greatest(settings_);
    const std::optional<float> longest = requests_[index].longestEdge;
    // With no edge in view there is nothing to go by.
    if (!longest) return std::min(shape.level().value_or(1), greatest);
    return nextLevel(shape.level(), idealLevel(*longest, settings_.edgePixels), greatest);
}

void GpuCages::evaluateStale() {
    const auto waits = [&](std::size_t i) { return requests_[i].inView && shapes_[i]->isStale(); };
    CageShape* largest = nullptr;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        if (!waits(i)) continue;
        if (largest == nullptr || shapes_[i]->vertexCount() > largest->vertexCount())
            largest = shapes_[i].get();
    }
    if (largest == nullptr) return;
    largest->chooseForm(evaluator_);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        if (waits(i)) shapes_[i]->evaluate(evaluator_);
    }
}

CageLines GpuCages::lines(CageLineKind kind, std::uint32_t index, std::uint32_t instance) {
    return shapes_[shown_[index].shape]->lines(kind, instance);
}

bool GpuCages::isLodClamped(std::uint32_t index) const {
    const CageLevels& levels = shapes_[index]->levels();
    const std::optional<float> longest = requests_[index].longestEdge;
    if (!longest || levels.fixedLevel(settings_)) return false;
    return idealLevel(*longest, settings_.edgePixels) > static_cast<float>(levels.greatest(settings_));
}

CageReport GpuCages::report() const {
    CageReport report;
    report.cages = shown_.size();
    report.subdivided = subdivided_;
    for (const Shown& shown : shown_) {
        report.triangles += shapes_[shown.shape]->triangles();
        report.lodClamped += isLodClamped(shown.shape) ? 1 : 0;
    }
    for (const CageLevels& levels : levels_) report.tableBytes += levels.tableBytes();
    bool any = false;
    for (const auto& shape : shapes_) {
        if (!shape->level()) continue;
        report.minLevel = any ? std::min(report.minLevel, *shape->level()) : *shape->level();
        report.maxLevel = std::max(report.maxLevel, *shape->level());
        any = true;
    }
    if (const std::optional<LimitForm> form = evaluator_.lastForm()) report.evaluator = toString(*form);
    return report;
}

}  // namespace candela
