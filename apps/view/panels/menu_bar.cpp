#include "common/scene_selection.h"
#include "common/timing.h"
#include "comparison.h"
#include "light_saving.h"
#include "panels/file_browser.h"
#include "panels/panel_values.h"
#include "panels/panels.h"
#include "panels/path_dialog.h"
#include "panels/widgets.h"
#include "shortcuts.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace {

/// The status shows the median of so many frames.
constexpr std::size_t statusFrames = 20;
constexpr float textStep = 1.1f, minText = 0.5f, maxText = 3.0f;

struct Dialogs {
    FileBrowser scene;
    PathDialog png{"Save the picture as shown", "Save", "a .png file", "candela.png"};
    PathDialog lights{"Save lights and cameras", "Save", "a .gltf or .glb file", "lights.gltf"};
    PathDialog exr{"Save radiance and channels", "Save", "an .exr file", "candela.exr"};
};

/// Whether an action can be done now.
bool isPossible(Action action, const ViewModel& model) {
    switch (action) {
        case Action::savePng:
        case Action::saveExr:
        case Action::saveLights:
        case Action::copyCommand:
        case Action::frameAll:
        case Action::expose:
        case Action::play:
        case Action::compare:
            return model.document != nullptr;
        case Action::swapSides:
            return model.document && model.comparison.shown;
        case Action::framePicked:
            return model.document && model.pickedNode;
        case Action::undo:
            return model.document && model.document->history().canUndo();
        case Action::redo:
            return model.document && model.document->history().canRedo();
        default:
            return true;
    }
}

void scaleText(ViewModel& model, float factor) {
    model.textScale = std::clamp(model.textScale * factor, minText, maxText);
}

void perform(Action action, ViewModel& model, Dialogs& dialogs) {
    switch (action) {
        case Action::help:
            model.helpShown = !model.helpShown;
            return;
        case Action::hidePanels:
            model.panelsHidden = !model.panelsHidden;
            return;
        case Action::open:
            return dialogs.scene.open();
        case Action::savePng:
            return dialogs.png.open();
        case Action::saveExr:
            return dialogs.exr.open();
        case Action::saveLights:
            return dialogs.lights.open();
        case Action::copyCommand:
            model.requests.copyCommand = true;
            return;
        case Action::gizmoMove:
            model.gizmo.mode = GizmoMode::move;
            return;
        case Action::gizmoTurn:
            model.gizmo.mode = GizmoMode::turn;
            return;
        case Action::gizmoScale:
            model.gizmo.mode = GizmoMode::scale;
            return;
        case Action::lightIcons:
            model.guides.lights = !model.guides.lights;
            return;
        case Action::grid:
            model.guides.grid = !model.guides.grid;
            return;
        case Action::compare:
            return toggleComparison(model);
        case Action::swapSides:
            return swapComparison(model);
        case Action::undo:
            return tryTo(model, [&] { model.document->undo(model.options); });
        case Action::redo:
            return tryTo(model, [&] { model.document->redo(model.options); });
        case Action::quit:
            model.requests.quit = true;
            return;
        case Action::frameAll:
            model.requests.frameAll = true;
            return;
        case Action::framePicked:
            model.requests.framePicked = true;
            return;
        case Action::expose:
            model.requests.measureExposure = true;
            return;
        case Action::play:
            model.playing = !model.playing;
            return;
        case Action::largerText:
            return scaleText(model, textStep);
        case Action::smallerText:
            return scaleText(model, 1.0f / textStep);
    }
}

/// A row of a menu, with the keys of its action.
void actionItem(const char* text, Action action, ViewModel& model, Dialogs& dialogs) {
    if (ImGui::MenuItem(text, keysOf(action), false, isPossible(action, model)))
        perform(action, model, dialogs);
}

void drawRecent(ViewModel& model) {
    if (!ImGui::BeginMenu("Open recent", !model.recent.empty())) return;
    for (std::size_t i = 0; i < model.recent.size(); ++i)
        if (listRow(i, Row::plain, model.recent[i])) model.requests.open = model.recent[i];
    ImGui::EndMenu();
}

void drawFileMenu(ViewModel& model, Dialogs& dialogs) {
    if (!ImGui::BeginMenu("File")) return;
    actionItem("Open...", Action::open, model, dialogs);
    drawRecent(model);
    ImGui::Separator();
    actionItem("Save PNG...", Action::savePng, model, dialogs);
    actionItem("Save EXR...", Action::saveExr, model, dialogs);
    actionItem("Save lights...", Action::saveLights, model, dialogs);
    actionItem("Copy candela-render command", Action::copyCommand, model, dialogs);
    ImGui::Separator();
    actionItem("Quit", Action::quit, model, dialogs);
    ImGui::EndMenu();
}

void drawEditMenu(ViewModel& model, Dialogs& dialogs) {
    if (!ImGui::BeginMenu("Edit")) return;
    actionItem("Undo", Action::undo, model, dialogs);
    actionItem("Redo", Action::redo, model, dialogs);
    ImGui::Separator();
    actionItem("Move", Action::gizmoMove, model, dialogs);
    actionItem("Turn", Action::gizmoTurn, model, dialogs);
    actionItem("Scale", Action::gizmoScale, model, dialogs);
    ImGui::EndMenu();
}

void drawViewMenu(ViewModel& model, Dialogs& dialogs) {
    if (!ImGui::BeginMenu("View")) return;
    OpenPanels& panels = model.panels;
    ImGui::MenuItem("Scene", nullptr, &panels.scene);
    ImGui::MenuItem("Materials", nullptr, &panels.material);
    ImGui::MenuItem("Lights", nullptr, &panels.lights);
    ImGui::MenuItem("Camera", nullptr, &panels.camera);
    ImGui::MenuItem("Colour", nullptr, &panels.color);
    ImGui::MenuItem("Drawing", nullptr, &panels.drawing);
    ImGui::MenuItem("Statistics", nullptr, &panels.statistics);
    ImGui::MenuItem("Probe", nullptr, &panels.probe);
    ImGui::MenuItem("Timeline", nullptr, &panels.timeline);
    if (ImGui::MenuItem("Reset the sizes of panels")) model.dockSizes = {};
    actionItem("Hide all panels", Action::hidePanels, model, dialogs);
    ImGui::Separator();
    ImGui::MenuItem("Outline of what is picked", nullptr, &model.guides.outline);
    ImGui::MenuItem("Lights as icons", keysOf(Action::lightIcons), &model.guides.lights);
    ImGui::MenuItem("Grid and axes", keysOf(Action::grid), &model.guides.grid);
    ImGui::Separator();
    actionItem("Larger text", Action::largerText, model, dialogs);
    actionItem("Smaller text", Action::smallerText, model, dialogs);
    ImGui::Separator();
    if (ImGui::MenuItem("Compare settings", keysOf(Action::compare), model.comparison.shown,
                        isPossible(Action::compare, model)))
        toggleComparison(model);
    actionItem("Swap sides", Action::swapSides, model, dialogs);
    ImGui::Separator();
    actionItem("Frame all", Action::frameAll, model, dialogs);
    actionItem("Frame picked", Action::framePicked, model, dialogs);
    actionItem("Expose", Action::expose, model, dialogs);
    ImGui::EndMenu();
}

void drawHelpMenu(ViewModel& model, Dialogs& dialogs) {
    if (!ImGui::BeginMenu("Help")) return;
    actionItem("Keys", Action::help, model, dialogs);
    if (ImGui::MenuItem("About")) model.aboutShown = true;
    ImGui::EndMenu();
}

/// A text that names variant `index` on the command line.
std::string variantText(const candela::Scene& scene, std::uint32_t index) {
    const std::string& name = scene.variants[index];
    return findVariant(scene, name) == index ? name : std::to_string(index);
}

void drawVariantMenu(ViewModel& model) {
    if (!model.document || model.document->scene().variants.empty()) return;
    if (!ImGui::BeginMenu("Variant")) return;
    const candela::Scene& scene = model.document->scene();
    const auto shown =
        model.options.variant ? findVariant(scene, *model.options.variant) : std::optional<std::uint32_t>();
    model.thumbnails.variantsShown = true;
    const std::vector<unsigned>& pictures = model.thumbnails.variants;
    const auto rowOf = [](bool isShown) { return isShown ? Row::selected : Row::plain; };
    if (pictureRow(0, rowOf(!shown), thumbnail(pictures, 0), "none")) model.requests.variant = "";
    for (std::uint32_t i = 0; i < scene.variants.size(); ++i)
        if (pictureRow(i + 1, rowOf(shown == i), thumbnail(pictures, i + 1), variantLabel(scene, i)))
            model.requests.variant = variantText(scene, i);
    ImGui::EndMenu();
}

std::string speedText(const std::deque<FrameRecord>& frames) {
    std::vector<double> times;
    for (auto frame = frames.rbegin(); frame != frames.rend() && times.size() < statusFrames; ++frame)
        times.push_back(frame->milliseconds);
    const double middle = median(std::move(times));
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), "%.1f ms, %.0f fps", middle, 1000.0 / std::max(middle, 0.01));
    return text.data();
}

std::string statusText(const ViewModel& model) {
    std::string text = model.frames.empty() ? "" : speedText(model.frames);
    if (!model.document) return text;
    if (!text.empty()) text += " | ";
    return text + countText(model.samples, "sample") + " | " +
           countText(model.document->lights().size(), "light") + " | " + candela::toString(model.technique);
}

void drawStatus(const ViewModel& model) {
    const std::string text = statusText(model);
    const float left = ImGui::GetWindowWidth() - ImGui::CalcTextSize(text.c_str()).x - ImGui::GetFontSize();
    ImGui::SameLine(std::max(left, ImGui::GetCursorPosX()));
    showDimText(text);
}

}  // namespace

void drawMenuBar(ViewModel& model) {
    static Dialogs dialogs;
    const std::optional<Action> pressed = pressedAction();
    if (pressed && isPossible(*pressed, model)) perform(*pressed, model, dialogs);
    if (std::exchange(model.requests.browse, false)) dialogs.scene.open();
    if (!model.panelsHidden && ImGui::BeginMainMenuBar()) {
        drawFileMenu(model, dialogs);
        drawEditMenu(model, dialogs);
        drawViewMenu(model, dialogs);
        drawVariantMenu(model);
        drawHelpMenu(model, dialogs);
        drawStatus(model);
        ImGui::EndMainMenuBar();
    }
    if (const auto scene = dialogs.scene.draw(model.sceneEndings)) model.requests.open = *scene;
    if (dialogs.png.draw()) model.requests.savePng = withEnding(dialogs.png.path(), ".png");
    if (dialogs.lights.draw()) model.requests.saveLights = lightFileName(dialogs.lights.path());
    if (dialogs.exr.draw()) model.requests.saveExr = withEnding(dialogs.exr.path(), ".exr");
}
