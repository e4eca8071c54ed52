#include "panels/panel.h"

#include <imgui.h>

#include <string>

namespace {

/// Whether only the title of a panel shows, as of its last frame.
std::array<bool, panelCount> collapsed{};

const ImGuiWindowFlags docked = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoFocusOnAppearing;

void drawSplitter(ViewModel& model, const Splitter& splitter, int id) {
    const PanelPlace& place = splitter.place;
    ImGui::SetNextWindowPos({place.position.x, place.position.y});
    ImGui::SetNextWindowSize({place.size.x, place.size.y});
    ImGui::Begin(
        ("splitter " + std::to_string(id)).c_str(), nullptr,
        docked | ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
    ImGui::SetCursorPos({0.0f, 0.0f});
    ImGui::InvisibleButton("bar", {place.size.x, place.size.y});
    const bool vertical = place.size.y > place.size.x;
    if (ImGui::IsItemHovered() || ImGui::IsItemActive())
        ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive())
        moveSplitter(splitter, {io.MouseDelta.x, io.MouseDelta.y}, model.layout, panelSpace(model),
                     model.dockSizes);
    ImGui::End();
}

}  // namespace

bool& openOf(OpenPanels& panels, Panel panel) {
    switch (panel) {
        case Panel::scene:
            return panels.scene;
        case Panel::materials:
            return panels.material;
        case Panel::lights:
            return panels.lights;
        case Panel::camera:
            return panels.camera;
        case Panel::color:
            return panels.color;
        case Panel::drawing:
            return panels.drawing;
        case Panel::statistics:
            return panels.statistics;
        case Panel::timeline:
            return panels.timeline;
        default:
            return panels.probe;
    }
}

PanelWindow::PanelWindow(ViewModel& model, Panel panel, const char* title, float labelLetters) {
    const auto index = static_cast<std::size_t>(panel);
    const PanelPlace& place = model.layout.panels[index];
    ImGui::SetNextWindowPos({place.position.x, place.position.y});
    ImGui::SetNextWindowSize({place.size.x, place.size.y});
    const bool row = dockOf(panel) == Dock::row;
    const ImGuiWindowFlags rowFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoScrollbar;
    visible_ =
        ImGui::Begin(title, row ? nullptr : &openOf(model.panels, panel), docked | (row ? rowFlags : 0));
    collapsed[index] = ImGui::IsWindowCollapsed();
    ImGui::PushItemWidth(-labelLetters * ImGui::GetFontSize());
}

PanelWindow::~PanelWindow() {
    ImGui::PopItemWidth();
    ImGui::End();
}

/// Also where no clip plays: one can be chosen.
bool hasTimeline(const ViewModel& model) {
    return model.document && (model.document->animated() || !model.document->scene().animations.empty());
}

PanelSpace panelSpace(const ViewModel& model) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float title = ImGui::GetFrameHeight();
    return {{display.x, display.y}, model.panelsHidden ? 0.0f : title, title, ImGui::GetFontSize()};
}

void layPanels(ViewModel& model) {
    PanelStates states;
    for (std::size_t i = 0; i < panelCount; ++i) {
        if (model.panelsHidden || !openOf(model.panels, Panel(i))) continue;
        if (Panel(i) == Panel::timeline && !hasTimeline(model)) continue;
        states.of[i] = collapsed[i] ? PanelStates::State::collapsed : PanelStates::State::open;
    }
    model.layout = layoutOf(panelSpace(model), states, model.dockSizes);
}

void drawSplitters(ViewModel& model) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    // A copy: a bar that is moved changes the layout of the next frame.
    const std::vector<Splitter> splitters = model.layout.splitters;
    for (std::size_t i = 0; i < splitters.size(); ++i) drawSplitter(model, splitters[i], static_cast<int>(i));
    ImGui::PopStyleVar(3);
}

void addError(ViewModel& model, const char* text) {
    // A value that is dragged fails in every frame.
    if (!model.messages.empty() && model.messages.back().text == text) return;
    model.messages.push_back({Message::Kind::error, text});
}

std::uint64_t sceneNumber(const ViewModel& model) {
    static const Document* last = nullptr;
    static std::uint64_t number = 0;
    // The next document is created while the last one lives, so that their addresses differ.
    if (model.document.get() != last || number == 0) {
        last = model.document.get();
        ++number;
    }
    return number;
}
