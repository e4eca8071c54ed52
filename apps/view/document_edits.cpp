// The part of `Document` that a user changes, and that is undone.

#include "common/scene_lights.h"
#include "document.h"

#include <algorithm>
#include <ranges>
#include <utility>

void Document::setMaterial(std::uint32_t index, const candela::Material& material) {
    MaterialEdit edit{index, scene_.materials[index], material, changedMaterials_[index]};
    showMaterial(index, material);
    changedMaterials_[index] = true;
    history_.record(std::move(edit));
}

void Document::showMaterial(std::uint32_t index, const candela::Material& material) {
    gpuScene_.setMaterial(index, material);
    scene_.materials[index] = material;
    for (candela::Animation& animation : scene_.animations) {
        std::erase_if(animation.properties, [&](const candela::PropertyChannel& channel) {
            return channel.element == index &&
                   candela::elementOf(channel.property) == candela::AnimatedElement::material;
        });
    }
    ++revision_;
}

void Document::setVisibility(std::uint32_t node, candela::GpuScene::Visibility visibility) {
    const VisibilityEdit edit{node, visibility_[node], visibility};
    showNode(node, visibility);
    history_.record(edit);
}

void Document::showNode(std::uint32_t node, candela::GpuScene::Visibility visibility) {
    gpuScene_.setVisibility(node, visibility);
    visibility_[node] = visibility;
    ++revision_;
}

void Document::setTransform(std::uint32_t node, const glm::mat4& local) {
    TransformEdit edit{node, {}, local, movedNodes_[node]};
    edit.before.transform = scene_.nodes[node].transform;
    edit.before.translationRemainder = scene_.nodes[node].translationRemainder;
    candela::Node placed;
    placed.transform = local;
    placeNode(node, placed);
    movedNodes_[node] = true;
    history_.record(std::move(edit));
}

void Document::placeNode(std::uint32_t node, const candela::Node& placed) {
    candela::Scene alone;
    alone.nodes = {placed};
    gpuScene_.setTransform(node, candela::worldTransforms(alone).front());
    scene_.nodes[node].transform = placed.transform;
    scene_.nodes[node].translationRemainder = placed.translationRemainder;
    for (candela::Animation& animation : scene_.animations) {
        std::erase_if(animation.channels, [node](const candela::AnimationChannel& channel) {
            return channel.node == node && channel.path != candela::AnimationPath::morphWeights;
        });
    }
    ++revision_;
    if (lightsChanged_ || restingLights_.empty()) return;
    const std::vector<candela::WorldLight> before = restingLights_;
    worldLights();
    const auto same = [](const candela::WorldLight& a, const candela::WorldLight& b) {
        return a.position == b.position && a.direction == b.direction;
    };
    if (!std::ranges::equal(before, restingLights_, same)) showLights();
}

/// Nothing changes when it throws.
void Document::changeLights(LightsEdit edit) {
    replaceLights(edit.first, edit.before.size(), edit.after);
    try {
        showLights();
    } catch (...) {
        replaceLights(edit.first, edit.after.size(), edit.before);
        showLights();
        throw;
    }
    edit.scatteredBefore = std::exchange(firstScattered_, edit.scatteredAfter);
    edit.changedBefore = std::exchange(lightsChanged_, edit.changedAfter);
    history_.record(std::move(edit));
}

void Document::replaceLights(std::size_t first, std::size_t count,
                             const std::vector<candela::WorldLight>& lights) {
    const auto from = restingLights_.begin() + static_cast<std::ptrdiff_t>(first);
    // Most often one light is replaced by another, among very many.
    if (count == lights.size()) {
        std::ranges::copy(lights, from);
        return;
    }
    const auto end = restingLights_.erase(from, from + static_cast<std::ptrdiff_t>(count));
    restingLights_.insert(end, lights.begin(), lights.end());
}

void Document::setLight(std::uint32_t index, const candela::WorldLight& light) {
    changeLights({.first = index,
                  .before = {restingLights_[index]},
                  .after = {light},
                  .scatteredAfter = firstScattered_,
                  .changedAfter = true});
}

void Document::addLight(const candela::WorldLight& light) {
    changeLights({.first = firstScattered_,
                  .before = {},
                  .after = {light},
                  .scatteredAfter = firstScattered_ + 1,
                  .changedAfter = true});
}

void Document::removeLight(std::uint32_t index) {
    changeLights({.first = index,
                  .before = {restingLights_[index]},
                  .after = {},
                  .scatteredAfter = index < firstScattered_ ? firstScattered_ - 1 : firstScattered_,
                  .changedAfter = true});
}

void Document::scatterLights(const candela::LightScatter& options) {
    scene_.lights.resize(ownLights_);
    addScatteredLights(scene_, options, "the scene");
    const std::vector<candela::WorldLight> placed =
        candela::worldLights(scene_, candela::worldTransforms(scene_, time_), time_);
    const auto first = static_cast<std::ptrdiff_t>(firstScattered_);
    changeLights({.first = firstScattered_,
                  .before = {restingLights_.begin() + first, restingLights_.end()},
                  .after = {placed.begin() + static_cast<std::ptrdiff_t>(ownLights_), placed.end()},
                  .scatteredAfter = firstScattered_,
                  .changedAfter = lightsChanged_});
}

void Document::setLightMotion(const LightMotion& motion) {
    const LightMotionEdit edit{motion_, motion};
    motion_ = motion;
    showLights();
    history_.record(edit);
}

namespace {

enum class Way { back, forth };

}  // namespace

/// Shows one side of an edit: what was there before it, or what is there after it.
struct Document::Shown {
    Document& document;
    SceneOptions& options;
    Way way;

    template <typename Value>
    const Value& side(const Value& before, const Value& after) const {
        return way == Way::back ? before : after;
    }

    void operator()(const MaterialEdit& edit) const {
        document.showMaterial(edit.material, side(edit.before, edit.after));
        document.changedMaterials_[edit.material] = side(edit.changedBefore, true);
    }
    void operator()(const VisibilityEdit& edit) const {
        document.showNode(edit.node, side(edit.before, edit.after));
    }
    void operator()(const LightsEdit& edit) const {
        document.replaceLights(edit.first, side(edit.after, edit.before).size(),
                               side(edit.before, edit.after));
        document.firstScattered_ = side(edit.scatteredBefore, edit.scatteredAfter);
        document.lightsChanged_ = side(edit.changedBefore, edit.changedAfter);
        document.showLights();
    }
    void operator()(const TransformEdit& edit) const {
        candela::Node after;
        after.transform = edit.after;
        document.placeNode(edit.node, side(edit.before, after));
        document.movedNodes_[edit.node] = side(edit.movedBefore, true);
    }
    void operator()(const LightMotionEdit& edit) const {
        document.motion_ = side(edit.before, edit.after);
        document.showLights();
    }
    void operator()(const OptionsEdit& edit) const {
        takeEditedOptions(side(edit.before, edit.after), options);
        const candela::SubdivisionSettings &a = edit.before.subdivision, &b = edit.after.subdivision;
        if (a.level != b.level || a.edgePixels != b.edgePixels || a.maxLevel != b.maxLevel)
            document.gpuScene_.setSubdivision(options.subdivision);
    }
};

void Document::undo(SceneOptions& options) {
    if (!history_.canUndo()) return;
    for (const Edit& edit : std::views::reverse(history_.undo()))
        std::visit(Shown{*this, options, Way::back}, edit);
    history_.rebase(options);
}

void Document::redo(SceneOptions& options) {
    if (!history_.canRedo()) return;
    for (const Edit& edit : history_.redo()) std::visit(Shown{*this, options, Way::forth}, edit);
    history_.rebase(options);
}
