#include "panels/color_values.h"
#include "panels/lobe_editor.h"
#include "panels/panel_values.h"
#include "panels/panels.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <algorithm>

namespace {

constexpr float listLines = 5.0f;
constexpr float brightestEmission = 1.0e20f;

struct Kept {
    ImGuiTextFilter filter;
    std::vector<std::uint32_t> list;  ///< As the filter and the picked node have it.
    bool listed = false;
    std::optional<std::uint32_t> listedNode;
    glm::vec3 emissionHue{1.0f};
    std::optional<std::uint32_t> emissionOf;
};

std::string nameOf(const candela::Scene& scene, std::uint32_t material) {
    return elementText("material", material, scene.materials[material].name);
}

/// Those of the picked node, then the others, as far as they pass the filter.
std::vector<std::uint32_t> listMaterials(const ViewModel& model, const ImGuiTextFilter& filter) {
    const candela::Scene& scene = model.document->scene();
    std::vector<std::uint32_t> list;
    if (model.pickedNode) list = materialsOfNode(scene, *model.pickedNode);
    std::vector<bool> listed(scene.materials.size(), false);
    for (const std::uint32_t material : list) listed[material] = true;
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i)
        if (!listed[i]) list.push_back(i);
    std::erase_if(list, [&](std::uint32_t i) { return !filter.PassFilter(nameOf(scene, i).c_str()); });
    return list;
}

/// With a node its first material is picked, unless one of its materials is already.
void pickOfNode(ViewModel& model) {
    if (!model.pickedNode) return;
    const auto own = materialsOfNode(model.document->scene(), *model.pickedNode);
    if (!own.empty() && std::ranges::find(own, model.pickedMaterial) == own.end())
        model.pickedMaterial = own.front();
}

void refreshList(ViewModel& model, Kept& kept) {
    const bool filterChanged = kept.filter.Draw("filter");
    const bool nodeChanged = !kept.listed || kept.listedNode != model.pickedNode;
    if (nodeChanged) pickOfNode(model);
    if (!nodeChanged && !filterChanged) return;
    kept.list = listMaterials(model, kept.filter);
    kept.listedNode = model.pickedNode;
    kept.listed = true;
}

void drawList(ViewModel& model, const Kept& kept) {
    const candela::Scene& scene = model.document->scene();
    ImGui::BeginChild("list", {0.0f, listLines * ImGui::GetTextLineHeightWithSpacing()}, true);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(kept.list.size()), ImGui::GetTextLineHeightWithSpacing());
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const std::uint32_t material = kept.list[static_cast<std::size_t>(i)];
            ImGui::PushID(static_cast<int>(material));
            colorPatch("color", scene.materials[material].baseColor);
            ImGui::SameLine();
            const Row row = model.pickedMaterial == material ? Row::selected : Row::plain;
            if (listRow(material, row, nameOf(scene, material))) model.pickedMaterial = material;
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
}

bool editEmission(candela::Material& material, Kept& kept, std::uint32_t index) {
    if (kept.emissionOf != index) kept.emissionHue = glm::vec3(1.0f);
    kept.emissionOf = index;
    SplitColor emission = splitColor(material.emission * material.emissionStrength, kept.emissionHue);
    bool changed = false;
    glm::vec3 hue = emission.hue;
    if (editColor("emission", hue)) {
        emission.hue = splitColor(hue, emission.hue).hue;
        changed = true;
    }
    changed = dragNumber("its strength", emission.strength,
                         {.max = brightestEmission, .speed = 0.01f, .format = "%.3f"}) ||
              changed;
    kept.emissionHue = emission.hue;
    if (!changed) return false;
    material.emission = emission.joined();
    material.emissionStrength = 1.0f;
    return true;
}

bool editNumbers(candela::Material& material) {
    glm::vec3 color(material.baseColor);
    bool changed = editColor("base colour", color);
    if (changed) material.baseColor = glm::vec4(color, material.baseColor.a);
    changed = slideNumber("metallic", material.metallic, {}) || changed;
    changed = slideNumber("roughness", material.roughness, {}) || changed;
    if (material.alphaMode == candela::AlphaMode::mask)
        changed = slideNumber("alpha cutoff", material.alphaCutoff, {}) || changed;
    if (material.alphaMode == candela::AlphaMode::blend)
        changed = slideNumber("alpha", material.baseColor.a, {}) || changed;
    if (material.normalTexture)
        changed = dragNumber("normal scale", material.normalScale, {.min = -16.0f, .max = 16.0f}) || changed;
    return changed;
}

void showTextures(const candela::Material& material) {
    std::string uses;
    const auto add = [&uses](const std::optional<candela::Texture>& texture, const char* use) {
        if (texture) uses += (uses.empty() ? "times textures of " : ", ") + std::string(use);
    };
    add(material.baseColorTexture, "base colour");
    add(material.metallicRoughnessTexture, "metal and roughness");
    add(material.normalTexture, "normals");
    add(material.emissionTexture, "emission");
    if (!uses.empty()) showWrappedText(uses);
    if (material.unlit) showWrappedText("unlit: shows its base colour, and no light falls on it");
}

void drawEditor(ViewModel& model, Kept& kept, std::uint32_t index) {
    candela::Material material = model.document->scene().materials[index];
    ImGui::PushID(static_cast<int>(index));
    bool changed = editNumbers(material);
    changed = editEmission(material, kept, index) || changed;
    if (!material.unlit) changed = editLobes(material) || changed;
    showTextures(material);
    ImGui::PopID();
    if (changed) tryTo(model, [&] { model.document->setMaterial(index, material); });
}

}  // namespace

void drawMaterialPanel(ViewModel& model) {
    const PanelWindow window(model, Panel::materials, "Materials");
    if (!window || !model.document) return;
    const std::size_t count = model.document->scene().materials.size();
    if (count == 0) return showDimText("The scene has no materials.");
    auto& kept = keptOfScene<Kept>(model);
    refreshList(model, kept);
    drawList(model, kept);
    if (!model.pickedMaterial || *model.pickedMaterial >= count) return showDimText("None is picked.");
    drawEditor(model, kept, *model.pickedMaterial);
}
