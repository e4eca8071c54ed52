#include "document.h"

#include "common/scene_lights.h"
#include "common/scene_selection.h"

#include <candela/default_lights.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace {

std::string label(const char* kind, std::size_t index, const std::string& name) {
    return std::string(kind) + " " + std::to_string(index) + (name.empty() ? "" : " '" + name + "'");
}

bool areEqual(const candela::WorldLight& a, const candela::WorldLight& b) {
    const auto numbers = [](const candela::WorldLight& light) {
        return std::tie(light.type, light.position, light.range, light.direction, light.intensity,
                        light.innerConeAngle, light.outerConeAngle, light.castsShadow, light.radius);
    };
    return numbers(a) == numbers(b);
}

}  // namespace

Document::Document(candela::ImportedScene imported, const candela::Context& context,
                   const candela::GpuSceneOptions& options, std::size_t scatteredLights)
    : scene_(std::move(imported.scene)),
      ownEnvironment_(std::exchange(scene_.environment, std::nullopt)),
      notes_(std::move(imported.report.notes)),
      gpuScene_(context, scene_, options),
      visibility_(scene_.nodes.size(), candela::GpuScene::Visibility::shown),
      restingLights_(candela::worldLights(scene_, candela::worldTransforms(scene_))),
      shownLights_(restingLights_),
      ownLights_(scene_.lights.size() - scatteredLights),
      firstScattered_(ownLights_),
      changedMaterials_(scene_.materials.size(), false),
      movedNodes_(scene_.nodes.size(), false) {}

candela::GpuScene Document::upload(const candela::Context& context,
                                   const candela::GpuSceneOptions& options) const {
    return uploaded(scene_, context, options);
}

candela::GpuScene Document::uploadVariant(std::optional<std::uint32_t> variant,
                                          const candela::Context& context,
                                          const candela::GpuSceneOptions& options) const {
    candela::Scene scene = scene_;
    candela::selectVariant(scene, variant);
    return uploaded(scene, context, options);
}

/// As the document is shown: posed, with its lights, without what is hidden.
candela::GpuScene Document::uploaded(const candela::Scene& scene, const candela::Context& context,
                                     const candela::GpuSceneOptions& options) const {
    candela::GpuScene uploaded(context, scene, options);
    uploaded.setTime(time_);
    for (std::uint32_t node = 0; node < visibility_.size(); ++node)
        if (visibility_[node] == candela::GpuScene::Visibility::hidden)
            uploaded.setVisibility(node, visibility_[node]);
    if (lightsTaken_) uploadLights(uploaded);
    return uploaded;
}

void Document::adopt(candela::GpuScene uploaded) {
    gpuScene_ = std::move(uploaded);
    ++revision_;
}

void Document::setVariant(const std::optional<std::string>& variant, const candela::Context& context,
                          const candela::GpuSceneOptions& options) {
    selectVariant(scene_, variant, "the scene");
    adopt(upload(context, options));
}

bool Document::animated() const {
    return motion_.moving || scene_.frameCallback ||
           std::ranges::any_of(scene_.animations, &candela::Animation::plays);
}

void Document::playAnimations(const std::vector<std::uint32_t>& animations) {
    playOnly(scene_, animations);
    gpuScene_.playAnimations(animations);
    framedBox_.reset();
    ++revision_;
    poseLights();
}

void Document::setTime(double seconds) {
    if (seconds == time_) return;
    gpuScene_.setTime(seconds);  // A frame callback may fail.
    time_ = seconds;
    ++revision_;
    poseLights();
}

/// Moves the lights to where their nodes and the time put them.
void Document::poseLights() {
    const bool carried = !lightsChanged_ && candela::isAnimated(scene_);
    if (carried) worldLights();
    if (lightsTaken_ && (carried || motion_.moving)) {
        showLights();
    } else if (carried) {
        shownLights_ = restingLights_;
    }
}

void Document::worldLights() {
    restingLights_ = candela::worldLights(scene_, candela::worldTransforms(scene_, time_), time_);
}

void Document::showLights() {
    lightsTaken_ = true;
    ++revision_;
    moveLights(restingLights_, motion_, time_, shownLights_);
    uploadLights(gpuScene_);
}

void Document::uploadLights(candela::GpuScene& scene) const {
    if (defaultLights_.empty() && !sun_) return scene.setLights(shownLights_);
    std::vector<candela::WorldLight> lights = shownLights_;
    if (sun_) lights.push_back(*sun_);
    lights.insert(lights.end(), defaultLights_.begin(), defaultLights_.end());
    scene.setLights(lights);
}

void Document::setDefaultLighting(const std::optional<DefaultLighting>& lighting) {
    std::vector<candela::WorldLight> lights;
    if (lighting) {
        const auto added = candela::defaultLights(lighting->view, lighting->exposure);
        lights.assign(added.begin(), added.end());
    }
    const auto same = [](const candela::WorldLight& a, const candela::WorldLight& b) {
        return a.direction == b.direction && a.intensity == b.intensity;
    };
    if (std::ranges::equal(lights, defaultLights_, same)) return;
    defaultLights_ = std::move(lights);
    lightsTaken_ = true;
    uploadLights(gpuScene_);
}

void Document::keepEnvironmentFiles() {
    if (!keptFiles_) keptFiles_.emplace();
}

EnvironmentLight Document::environmentOf(const SceneOptions& options) {
    const bool isKept = keptFiles_ && options.environment.source == EnvironmentOption::Source::file;
    if (!isKept) return readEnvironment(options);
    const auto found = keptFiles_->find(options.environment.file);
    if (found != keptFiles_->end()) return found->second;
    return keptFiles_->emplace(options.environment.file, readEnvironment(options)).first->second;
}

EnvironmentLight Document::readEnvironment(const SceneOptions& options) {
    // `scene_` has the environment that is shown.
    std::swap(scene_.environment, ownEnvironment_);
    try {
        EnvironmentLight light = loadEnvironment(scene_, options);
        std::swap(scene_.environment, ownEnvironment_);
        return light;
    } catch (...) {
        std::swap(scene_.environment, ownEnvironment_);
        throw;
    }
}

std::vector<std::string> Document::setEnvironment(const SceneOptions& options) {
    const EnvironmentOption &wanted = options.environment, &shown = shownEnvironment_.option;
    const bool isSame =
        shownEnvironment_.isLoaded && wanted.source == shown.source && wanted.file == shown.file;
    if (isSame && wanted.degrees == shown.degrees && wanted.stops == shown.stops &&
        options.background == shownEnvironment_.background)
        return {};
    if (isSame) {
        placeEnvironment(options);
        return {};
    }
    EnvironmentLight loaded = environmentOf(options);
    std::vector<std::string> notes = std::move(loaded.notes);
    setEnvironment(options, std::move(loaded));
    return notes;
}

void Document::setEnvironment(const SceneOptions& options, EnvironmentLight loaded) {
    EnvironmentLight placed = placedEnvironment(loaded, options);
    gpuScene_.setEnvironment(placed.environment);
    scene_.environment = std::move(placed.environment);
    if (loaded.environment) loaded.environment->picture = {};
    shownEnvironment_.loaded = std::move(loaded);
    shownEnvironment_.isLoaded = true;
    placeEnvironment(options);
}

void Document::placeEnvironment(const SceneOptions& options) {
    const EnvironmentLight placed = placedEnvironment(shownEnvironment_.loaded, options);
    if (placed.environment) {
        const candela::Environment& from = *placed.environment;
        gpuScene_.setEnvironmentSettings(
            {from.rotation, from.intensity, from.isBackground, from.occlusionDistance});
        scene_.environment->rotation = from.rotation;
        scene_.environment->intensity = from.intensity;
        scene_.environment->isBackground = from.isBackground;
    }
    shownEnvironment_.option = options.environment;
    shownEnvironment_.background = options.background;
    const bool hadSun = sun_.has_value();
    sun_.reset();
    if (placed.sun) {
        candela::Scene alone;
        alone.lights = {*placed.sun};
        sun_ = candela::worldLights(alone, {}).front();
    }
    if (!sun_ && !hadSun) return;
    lightsTaken_ = true;
    uploadLights(gpuScene_);
}

void Document::keepSavedLights(const std::string& file) {
    savedLights_ = {file, shownLights_};
}

std::optional<std::string> Document::fileOfLights() const {
    const bool shown =
        !savedLights_.file.empty() && std::ranges::equal(shownLights_, savedLights_.lights, areEqual);
    return shown ? std::optional(savedLights_.file) : std::nullopt;
}

std::vector<std::string> Document::changes() const {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < changedMaterials_.size(); ++i)
        if (changedMaterials_[i]) texts.push_back(label("material", i, scene_.materials[i].name));
    for (std::size_t i = 0; i < visibility_.size(); ++i)
        if (visibility_[i] == candela::GpuScene::Visibility::hidden)
            texts.push_back("hidden " + label("node", i, scene_.nodes[i].name));
    for (std::size_t i = 0; i < movedNodes_.size(); ++i)
        if (movedNodes_[i]) texts.push_back("moved " + label("node", i, scene_.nodes[i].name));
    if (fileOfLights()) return texts;
    if (lightsChanged_) texts.emplace_back("edited, added or removed lights");
    if (motion_.moving) texts.emplace_back("lights in motion");
    return texts;
}

candela::Bounds Document::bounds() const {
    return sceneBounds(scene_, time_);
}

candela::Bounds Document::bounds(std::uint32_t node) const {
    const std::vector<glm::mat4> world = candela::worldTransforms(scene_, time_);
    std::vector<bool> inside(scene_.nodes.size(), false);
    candela::Bounds box;
    // Parents stand before their children.
    for (std::uint32_t i = node; i < scene_.nodes.size(); ++i) {
        const auto& parent = scene_.nodes[i].parent;
        inside[i] = i == node || (parent && inside[*parent]);
        if (inside[i]) box.add(candela::nodeBounds(scene_, i, world, time_));
    }
    return box;
}

const candela::Bounds& Document::framedBox() {
    if (!framedBox_) framedBox_ = ::framedBox(scene_);
    return *framedBox_;
}
