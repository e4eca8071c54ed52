#include "scene_selection.h"

#include <candela/error.h>
#include <candela/nearest_name.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace {

constexpr std::size_t maxListed = 20;

std::vector<std::uint32_t> allOf(const candela::Scene& scene) {
    std::vector<std::uint32_t> all(scene.animations.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

/// The labels of elements `first` to `count` - 1.
template <typename Label>
std::string listed(std::size_t count, std::uint32_t first, const Label& label) {
    std::string text;
    for (std::uint32_t i = first; i < count; ++i) {
        if (i - first == maxListed) return text + " and " + std::to_string(count - i) + " more";
        text += (text.empty() ? "" : ", ") + label(i);
    }
    return text;
}

std::string listedAnimations(const candela::Scene& scene, std::uint32_t first) {
    return listed(scene.animations.size(), first, [&](std::uint32_t i) { return animationLabel(scene, i); });
}

/// By name first: a scene may call its animations "1" and "2".
template <typename Name>
std::optional<std::uint32_t> findElement(std::size_t count, const std::string& text, const Name& name) {
    for (std::uint32_t i = 0; i < count; ++i)
        if (!text.empty() && name(i) == text) return i;
    std::uint32_t index = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, index);
    if (error != std::errc{} || stop != end || index >= count) return std::nullopt;
    return index;
}

std::optional<std::uint32_t> findAnimation(const candela::Scene& scene, const std::string& text) {
    return findElement(scene.animations.size(), text,
                       [&](std::uint32_t i) -> const std::string& { return scene.animations[i].name; });
}

std::vector<std::string> animationNames(const candela::Scene& scene) {
    std::vector<std::string> names;
    for (const candela::Animation& animation : scene.animations) names.push_back(animation.name);
    return names;
}

std::string labelOf(std::uint32_t index, const std::string& name) {
    return std::to_string(index) + (name.empty() ? "" : " \"" + name + "\"");
}

}  // namespace

std::vector<std::uint32_t> selectedAnimations(const candela::Scene& scene, const SceneOptions& options) {
    if (options.animation == "all") return allOf(scene);
    if (options.animation == "none") return {};
    if (!options.animation) return scene.animations.empty() ? allOf(scene) : std::vector<std::uint32_t>{0};
    if (const auto found = findAnimation(scene, *options.animation)) return {*found};
    throw candela::Error(
        candela::ErrorKind::badInput, options.scene,
        "no animation \"" + *options.animation + "\"; " +
            (scene.animations.empty() ? "the scene has none" : "there are " + listedAnimations(scene, 0)) +
            candela::didYouMean(*options.animation, animationNames(scene)));
}

void playOnly(candela::Scene& scene, const std::vector<std::uint32_t>& animations) {
    for (candela::Animation& animation : scene.animations) animation.plays = false;
    for (const std::uint32_t index : animations) scene.animations[index].plays = true;
}

std::optional<std::string> selectAnimations(candela::Scene& scene, const SceneOptions& options) {
    playOnly(scene, selectedAnimations(scene, options));
    if (options.animation || scene.animations.size() < 2) return std::nullopt;
    return "of the animations only " + animationLabel(scene, 0) +
           " plays; --animation selects others: " + listedAnimations(scene, 1);
}

std::string animationLabel(const candela::Scene& scene, std::uint32_t index) {
    return labelOf(index, scene.animations[index].name);
}

std::optional<std::uint32_t> findVariant(const candela::Scene& scene, const std::string& text) {
    return findElement(scene.variants.size(), text,
                       [&](std::uint32_t i) -> const std::string& { return scene.variants[i]; });
}

void selectVariant(candela::Scene& scene, const std::optional<std::string>& variant,
                   const std::string& path) {
    if (!variant) return candela::selectVariant(scene, std::nullopt);
    const std::optional<std::uint32_t> found = findVariant(scene, *variant);
    if (found) return candela::selectVariant(scene, found);
    const std::string all =
        listed(scene.variants.size(), 0, [&](std::uint32_t i) { return variantLabel(scene, i); });
    throw candela::Error(candela::ErrorKind::badInput, path,
                         "no variant \"" + *variant + "\"; " +
                             (all.empty() ? "the scene has none" : "there are " + all) +
                             candela::didYouMean(*variant, scene.variants));
}

std::string variantLabel(const candela::Scene& scene, std::uint32_t index) {
    return labelOf(index, scene.variants[index]);
}

float lastKeyTime(const candela::Animation& animation) {
    float last = 0.0f;
    for (const candela::AnimationChannel& channel : animation.channels)
        last = std::max(last, channel.times.back());
    for (const candela::PropertyChannel& channel : animation.properties)
        last = std::max(last, channel.times.back());
    return last;
}

double lastKeyTime(const candela::Scene& scene) {
    double last = std::max(candela::frameCallbackSpan(scene).last, 0.0);
    for (const candela::Animation& animation : scene.animations) {
        if (animation.plays) last = std::max<double>(last, lastKeyTime(animation));
    }
    return last;
}

double poseTime(const candela::Scene& scene, const SceneOptions& options, double seconds) {
    const double last = options.repeatAnimations ? lastKeyTime(scene) : 0.0;
    if (last <= 0.0) return seconds;
    const double time = std::fmod(seconds, last);
    return time < 0.0 ? time + last : time;
}

namespace {

constexpr float defaultFov = 0.785398f;  // 45 degrees

/// The near plane of --eye, as a share of the distance to --target: what is looked at from close by may be a
/// small part of the scene.
constexpr float nearShareOfDistance = 0.01f;

std::uint32_t numberOf(const candela::Scene& scene, std::uint32_t index) {
    return scene.cameras[index].number.value_or(index);
}

const std::string& nodeNameOf(const candela::Scene& scene, std::uint32_t index) {
    static const std::string none;
    const auto& node = scene.cameras[index].node;
    return node ? scene.nodes[*node].name : none;
}

template <typename Matches>
std::optional<std::uint32_t> firstCamera(const candela::Scene& scene, const Matches& matches) {
    for (std::uint32_t i = 0; i < scene.cameras.size(); ++i)
        if (matches(i)) return i;
    return std::nullopt;
}

candela::CameraView eyeView(const candela::Scene& scene, const EyeOptions& options, float fov,
                            const candela::Bounds& box) {
    const glm::vec3 eye(options.eye - scene.origin), target(options.target - scene.origin);
    candela::CameraView view = candela::lookAt(eye, target, fov);
    view.nearPlane =
        std::min(candela::defaultNearPlane(box), nearShareOfDistance * glm::distance(eye, target));
    return view;
}

candela::CameraView frameView(const SceneOptions& options, const candela::Bounds& box) {
    const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
    return options.verticalFov ? candela::frameBounds(box, aspect, *options.verticalFov)
                               : candela::frameBounds(box, aspect);
}

}  // namespace

candela::Bounds framedBox(const candela::Scene& scene) {
    candela::Bounds box = candela::framingBounds(scene);
    if (!box.empty()) return box;
    for (const candela::WorldLight& light : candela::worldLights(scene, candela::worldTransforms(scene))) {
        if (light.type == candela::LightType::directional) continue;
        box.min = glm::min(box.min, light.position);
        box.max = glm::max(box.max, light.position);
    }
    return box;
}

std::optional<std::uint32_t> findCamera(const candela::Scene& scene, const std::string& text) {
    if (text.empty()) return std::nullopt;
    if (const auto found = firstCamera(scene, [&](std::uint32_t i) { return nodeNameOf(scene, i) == text; }))
        return found;
    if (const auto found = firstCamera(scene, [&](std::uint32_t i) { return scene.cameras[i].name == text; }))
        return found;
    std::uint32_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return firstCamera(scene, [&](std::uint32_t i) { return numberOf(scene, i) == number; });
}

std::string cameraText(const candela::Scene& scene, std::uint32_t index) {
    const std::string number = std::to_string(numberOf(scene, index));
    for (const std::string& text : {number, nodeNameOf(scene, index), scene.cameras[index].name})
        if (!text.empty() && findCamera(scene, text) == index) return text;
    return number;
}

std::string cameraLabel(const candela::Scene& scene, std::uint32_t index) {
    const std::string& name = scene.cameras[index].name;
    const std::string& node = nodeNameOf(scene, index);
    std::string label = std::to_string(numberOf(scene, index));
    if (!name.empty()) label += " \"" + name + "\"";
    if (!node.empty() && node != name) label += " of node \"" + node + "\"";
    return label;
}

std::string listCameras(const candela::Scene& scene, const std::string& wanted) {
    if (scene.cameras.empty()) return "the scene has none";
    std::string text = "there are";
    for (std::uint32_t i = 0; i < scene.cameras.size(); ++i)
        text += (i == 0 ? " " : ", ") + cameraLabel(scene, i);
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < scene.cameras.size(); ++i)
        names.insert(names.end(), {nodeNameOf(scene, i), scene.cameras[i].name});
    return text + candela::didYouMean(wanted, names);
}

std::string cameraName(const candela::Scene& scene, std::uint32_t index) {
    if (const std::string& node = nodeNameOf(scene, index); !node.empty()) return node;
    const std::string& own = scene.cameras[index].name;
    return own.empty() ? std::to_string(numberOf(scene, index)) : own;
}

CameraSelection::CameraSelection(const candela::Scene& scene, const SceneOptions& options,
                                 const std::function<candela::Bounds()>& box)
    : scene_(scene), verticalFov_(options.verticalFov), orthographicHeight_(options.orthographicHeight) {
    if (options.camera) {
        const std::optional<std::uint32_t> found = findCamera(scene, *options.camera);
        if (!found)
            throw candela::Error(
                candela::ErrorKind::badInput, options.scene,
                "no camera \"" + *options.camera + "\"; " + listCameras(scene, *options.camera));
        camera_ = *found;
    }
    if (options.eye) {
        fixed_ = eyeView(scene, *options.eye, options.verticalFov.value_or(defaultFov), box());
    } else if (scene.cameras.empty()) {
        fixed_ = frameView(options, box());
    }
    if (fixed_) useLensOptions(*fixed_);
}

CameraSelection::CameraSelection(const candela::Scene& scene, const SceneOptions& options,
                                 std::uint32_t index)
    : scene_(scene),
      verticalFov_(options.verticalFov),
      orthographicHeight_(options.orthographicHeight),
      camera_(index) {}

/// --fov takes the place of an orthographic lens, and --ortho that of a perspective one.
void CameraSelection::useLensOptions(candela::CameraView& view) const {
    if (verticalFov_) {
        view.verticalFov = *verticalFov_;
        view.orthographicHeight.reset();
        view.nearPlane = view.nearPlane > 0.0f ? view.nearPlane : candela::CameraView().nearPlane;
    }
    if (!orthographicHeight_) return;
    view.orthographicHeight = orthographicHeight_;
    if (fixed_) view.nearPlane = 0.0f;
}

candela::CameraView CameraSelection::at(double time) const {
    if (fixed_) return *fixed_;
    candela::CameraView view =
        candela::cameraView(scene_, camera_, candela::worldTransforms(scene_, time), time);
    useLensOptions(view);
    return view;
}
