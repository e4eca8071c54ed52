#include "panels/lobe_editor.h"

#include "panels/widgets.h"

#include <imgui.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

constexpr NumberRange nanometres{.max = 2000.0f, .speed = 2.0f, .format = "%.0f nm"};
constexpr NumberRange indices{.min = 1.0f, .max = 4.0f, .speed = 0.01f, .format = "%.2f"};
constexpr NumberRange metres{.max = 1000.0f, .speed = 0.002f, .format = "%.3f m"};

/// Runs `edit` where the lobe is unfolded. Returns whether it changed anything.
template <typename Edit>
bool inTree(const char* label, const Edit& edit) {
    if (!ImGui::TreeNode(label)) return false;
    const bool changed = edit();
    ImGui::TreePop();
    return changed;
}

bool editReflectance(candela::Material& material) {
    // An infinite index is that of specular-glossiness materials, and stays.
    bool changed = std::isfinite(material.ior) && slideNumber("index of refraction", material.ior, indices);
    changed = slideNumber("factor", material.specular.factor, {}) || changed;
    return editColor("colour", material.specular.color) || changed;
}

bool editClearcoat(candela::Clearcoat& coat) {
    bool changed = slideNumber("factor", coat.factor, {});
    changed = slideNumber("roughness", coat.roughness, {}) || changed;
    if (coat.normalTexture)
        changed = dragNumber("normal scale", coat.normalScale, {.min = -16.0f, .max = 16.0f}) || changed;
    return changed;
}

bool editSheen(candela::Sheen& sheen) {
    const bool changed = editColor("colour", sheen.color);
    return slideNumber("roughness", sheen.roughness, {}) || changed;
}

bool editAnisotropy(candela::Anisotropy& anisotropy) {
    constexpr float degrees = 180.0f / std::numbers::pi_v<float>;
    bool changed = slideNumber("strength", anisotropy.strength, {});
    float rotation = anisotropy.rotation * degrees;
    if (slideNumber("rotation", rotation, {.min = -180.0f, .max = 180.0f, .format = "%.0f°"})) {
        anisotropy.rotation = rotation / degrees;
        changed = true;
    }
    return changed;
}

bool editIridescence(candela::Iridescence& film) {
    bool changed = slideNumber("factor", film.factor, {});
    changed = slideNumber("index of refraction", film.ior, indices) || changed;
    if (film.thicknessTexture)
        changed = dragNumber("minimum thickness", film.minThickness, nanometres) || changed;
    return dragNumber("thickness", film.maxThickness, nanometres) || changed;
}

bool editVolume(candela::Volume& volume) {
    bool changed = dragNumber("thickness", volume.thickness, metres);
    changed = editColor("what it leaves of white", volume.attenuationColor) || changed;
    float distance = std::isfinite(volume.attenuationDistance) ? volume.attenuationDistance : 0.0f;
    if (dragNumber("after (0: it absorbs nothing)", distance, metres)) {
        volume.attenuationDistance = distance > 0.0f ? distance : std::numeric_limits<float>::infinity();
        changed = true;
    }
    return dragNumber("dispersion", volume.dispersion, {.max = 10.0f, .speed = 0.01f}) || changed;
}

bool editDiffuseTransmission(candela::DiffuseTransmission& transmission) {
    const bool changed = slideNumber("factor", transmission.factor, {});
    return editColor("colour", transmission.color) || changed;
}

}  // namespace

bool editLobes(candela::Material& material) {
    return inTree("more lobes", [&] {
        bool changed = inTree("reflectance", [&] { return editReflectance(material); });
        changed = inTree("clear coat", [&] { return editClearcoat(material.clearcoat); }) || changed;
        changed = inTree("sheen", [&] { return editSheen(material.sheen); }) || changed;
        changed = inTree("anisotropy", [&] { return editAnisotropy(material.anisotropy); }) || changed;
        changed = inTree("iridescence", [&] { return editIridescence(material.iridescence); }) || changed;
        changed = slideNumber("transmission", material.transmission.factor, {}) || changed;
        changed = inTree("volume", [&] { return editVolume(material.volume); }) || changed;
        return inTree("diffuse transmission",
                      [&] { return editDiffuseTransmission(material.diffuseTransmission); }) ||
               changed;
    });
}
