#include <candela/default_lights.h>

#include "base/error_context.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace candela {

namespace {

bool shines(const Light& light) {
    return light.intensity > 0.0f && std::max({light.color.r, light.color.g, light.color.b}) > 0.0f;
}

/// Whether more than half of the texels have a colour channel over 0.
bool isMostlyOverBlack(const Image& image) {
    const std::size_t texel = texelSize(image.format), color = texel / 4 * 3;
    std::size_t overBlack = 0;
    for (std::size_t at = 0; at + texel <= image.pixels.size(); at += texel) {
        const std::span<const std::byte> rgb(image.pixels.data() + at, color);
        overBlack += std::ranges::any_of(rgb, [](std::byte value) { return value != std::byte{0}; });
    }
    return 2 * overBlack * texel > image.pixels.size();
}

bool emits(const Scene& scene, const Material& material) {
    if (material.unlit) return true;
    if (material.emission * material.emissionStrength == glm::vec3(0.0f)) return false;
    const std::optional<Texture>& texture = material.emissionTexture;
    return !texture || texture->image >= scene.images.size() ||
           isMostlyOverBlack(scene.images[texture->image]);
}

/// For each material, whether a node shows a surface of it.
std::vector<bool> shownMaterials(const Scene& scene) {
    std::vector<bool> shown(scene.materials.size(), false);
    const auto show = [&](std::optional<std::uint32_t> material) {
        if (material && *material < shown.size()) shown[*material] = true;
    };
    for (const Node& node : scene.nodes) {
        if (node.mesh && *node.mesh < scene.meshes.size()) {
            for (const Submesh& submesh : scene.meshes[*node.mesh].submeshes) show(submesh.material);
        }
        if (node.cage && *node.cage < scene.cages.size()) {
            for (const auto& material : scene.cages[*node.cage].faceMaterials) show(material);
        }
    }
    return shown;
}

/// A light of the rig. Directions are in the camera's frame, towards the light; the strengths are relative to
/// each other.
struct RigLight {
    glm::vec3 towards;
    float strength;
};

constexpr std::array<RigLight, 3> rig{{
    {{-0.5f, 0.6f, 0.7f}, 1.0f},  // key
    {{0.8f, 0.1f, 0.6f}, 0.4f},   // fill
    {{0.3f, 0.7f, -0.7f}, 0.8f},  // rim
}};

/// Whether an animation that plays gives a light or a material a value that may shine.
bool animatesLight(const Animation& animation) {
    using P = AnimatedProperty;
    return animation.plays && std::ranges::any_of(animation.properties, [](const PropertyChannel& channel) {
               const P property = channel.property;
               const bool isOfLight = property == P::lightColor || property == P::lightIntensity ||
                                      property == P::emission || property == P::emissionStrength;
               return isOfLight &&
                      std::ranges::any_of(channel.values, [](float value) { return value > 0.0f; });
           });
}

}  // namespace

bool hasLight(const Scene& scene) {
    if (std::ranges::any_of(scene.lights, shines)) return true;
    if (std::ranges::any_of(scene.animations, animatesLight)) return true;
    // Which values a frame callback gives lights, only its plugin knows.
    if (scene.frameCallback && !scene.lights.empty()) return true;
    if (scene.environment && scene.environment->intensity > 0.0f) return true;
    const std::vector<bool> shown = shownMaterials(scene);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (shown[i] && emits(scene, scene.materials[i])) return true;
    }
    return false;
}

namespace {

void requireRig(const CameraView& view, double exposure) {
    const ErrorContext context("default lights");
    context.requireFinite("the view's matrix", view.worldFromCamera);
    context.require(exposure >= -100.0 && exposure <= 100.0, "the exposure must be -100 to 100 stops");
}

/// In lux. A Lambert surface that faces the camera reflects albedo / pi of it.
double neutralIrradiance(double exposure) {
    return std::numbers::pi * std::exp2(-exposure);
}

}  // namespace

std::array<WorldLight, 3> defaultLights(const CameraView& view, double exposure) {
    requireRig(view, exposure);
    float irradiance = 0.0f;
    for (const RigLight& light : rig)
        irradiance += light.strength * std::max(glm::normalize(light.towards).z, 0.0f);
    const auto scale = static_cast<float>(neutralIrradiance(exposure)) / irradiance;
    std::array<WorldLight, 3> lights;
    for (std::size_t i = 0; i < rig.size(); ++i) {
        lights[i].type = LightType::directional;
        lights[i].direction = glm::normalize(glm::mat3(view.worldFromCamera) * -rig[i].towards);
        lights[i].intensity = glm::vec3(rig[i].strength * scale);
        lights[i].castsShadow = false;
    }
    return lights;
}

WorldLight headlight(const CameraView& view, double exposure) {
    requireRig(view, exposure);
    WorldLight light;
    light.type = LightType::directional;
    light.direction = -glm::normalize(glm::vec3(view.worldFromCamera[2]));
    light.intensity = glm::vec3(static_cast<float>(neutralIrradiance(exposure)));
    light.castsShadow = false;
    return light;
}

}  // namespace candela
