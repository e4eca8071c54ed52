#include "common/scene_selection.h"
#include "common/timing.h"
#include "panels/panel_values.h"
#include "panels/panels.h"
#include "panels/widgets.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr float fieldLetters = 36.0f;

/// A modal window that asks for a path.
class PathDialog {
  public:
    /// `title` names the window, `action` its button, `hint` shows while nothing is typed.
    PathDialog(const char* title, const char* action, const char* hint, std::string path);

    /// Shows it from the next `draw` on.
    void open() { opening_ = true; }
    /// Returns whether the user has confirmed; `path` then is what was typed.
    bool draw();
    const std::string& path() const { return path_; }

  private:
    const char* title_;
    const char* action_;
    const char* hint_;
    std::string path_;
    bool opening_ = false;
};

PathDialog::PathDialog(const char* title, const char* action, const char* hint, std::string path)
    : title_(title), action_(action), hint_(hint), path_(std::move(path)) {}

bool PathDialog::draw() {
    if (std::exchange(opening_, false)) ImGui::OpenPopup(title_);
    const ImVec2 center = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(center, ImGuiCond_Appearing, {0.5f, 0.5f});
    if (!ImGui::BeginPopupModal(title_, nullptr,
                                ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings))
        return false;
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(fieldLetters * ImGui::GetFontSize());
    const bool entered =
        ImGui::InputTextWithHint("##path", hint_, &path_, ImGuiInputTextFlags_EnterReturnsTrue);
    const bool confirmed = (ImGui::Button(action_) || entered) && !path_.empty();
    ImGui::SameLine();
    const bool left = ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (confirmed || left) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return confirmed;
}

/// The status shows the median of so many frames.
constexpr std::size_t statusFrames = 20;

struct Dialogs {
    PathDialog scene{"Open a scene", "Open", "a file (.gltf, .glb, .obj), or plaza:4096", ""};
    PathDialog png{"Save the picture as shown", "Save", "a .png file", "candela.png"};
    PathDialog exr{"Save radiance and channels", "Save", "an .exr file", "candela.exr"};
};

void drawRecent(ViewModel& model) {
    if (!ImGui::BeginMenu("Open recent", !model.recent.empty())) return;
    for (std::size_t i = 0; i < model.recent.size(); ++i)
        if (listRow(i, Row::plain, model.recent[i])) model.requests.open = model.recent[i];
    ImGui::EndMenu();
}

void drawFileMenu(ViewModel& model, Dialogs& dialogs) {
    if (!ImGui::BeginMenu("File")) return;
    const bool scene = model.document != nullptr;
    if (ImGui::MenuItem("Open...", "Ctrl+O")) dialogs.scene.open();
    drawRecent(model);
    ImGui::Separator();
    if (ImGui::MenuItem("Save PNG...", "Ctrl+S", false, scene)) dialogs.png.open();
    if (ImGui::MenuItem("Save EXR...", nullptr, false, scene)) dialogs.exr.open();
    if (ImGui::MenuItem("Copy candela-render command", nullptr, false, scene))
        model.requests.copyCommand = true;
    ImGui::EndMenu();
}

void drawViewMenu(ViewModel& model) {
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
    if (ImGui::MenuItem("Arrange the panels")) beginArrangement();
    ImGui::Separator();
    const bool scene = model.document != nullptr;
    if (ImGui::MenuItem("Frame all", "F", false, scene)) model.requests.frameAll = true;
    if (ImGui::MenuItem("Frame picked", "Shift+F", false, scene && model.pickedNode))
        model.requests.framePicked = true;
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
    if (ImGui::MenuItem("none", nullptr, !shown)) model.requests.variant = "";
    for (std::uint32_t i = 0; i < scene.variants.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::MenuItem(variantLabel(scene, i).c_str(), nullptr, shown == i))
            model.requests.variant = variantText(scene, i);
        ImGui::PopID();
    }
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

std::string samplesText(std::uint32_t samples) {
    return groupedText(samples) + (samples == 1 ? " sample" : " samples");
}

std::string statusText(const ViewModel& model) {
    std::string text = model.frames.empty() ? "" : speedText(model.frames);
    if (!model.document) return text;
    if (!text.empty()) text += " | ";
    return text + samplesText(model.samples) + " | " + groupedText(model.document->lights().size()) +
           " lights | " + candela::toString(model.technique);
}

void drawStatus(const ViewModel& model) {
    const std::string text = statusText(model);
    const float left = ImGui::GetWindowWidth() - ImGui::CalcTextSize(text.c_str()).x - ImGui::GetFontSize();
    ImGui::SameLine(std::max(left, ImGui::GetCursorPosX()));
    showText(text);
}

/// Letters have the key numbers of GLFW, which are those of ASCII.
void readShortcuts(const ViewModel& model, Dialogs& dialogs) {
    if (!ImGui::GetIO().KeyCtrl || ImGui::GetIO().WantTextInput) return;
    if (ImGui::IsKeyPressed('O', false)) dialogs.scene.open();
    if (ImGui::IsKeyPressed('S', false) && model.document) dialogs.png.open();
}

}  // namespace

void drawMenuBar(ViewModel& model) {
    static Dialogs dialogs;
    readShortcuts(model, dialogs);
    if (ImGui::BeginMainMenuBar()) {
        drawFileMenu(model, dialogs);
        drawViewMenu(model);
        drawVariantMenu(model);
        drawStatus(model);
        ImGui::EndMainMenuBar();
    }
    if (dialogs.scene.draw()) model.requests.open = dialogs.scene.path();
    if (dialogs.png.draw()) model.requests.savePng = withEnding(dialogs.png.path(), ".png");
    if (dialogs.exr.draw()) model.requests.saveExr = withEnding(dialogs.exr.path(), ".exr");
}
