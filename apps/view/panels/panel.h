#pragma once

// What every panel is built on: its window, its state for the open scene, and what becomes of errors.

#include "panels/layout.h"
#include "view_model.h"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <vector>

/// Whether a panel is open.
bool& openOf(OpenPanels& panels, Panel panel);

/// The ImGui window of one panel at its place in `ViewModel::layout`, for the lifetime of the object.
class PanelWindow {
  public:
    /// `labelLetters`: what is left for the labels right of fields, in heights of a letter.
    PanelWindow(ViewModel& model, Panel panel, const char* title, float labelLetters = 7.5f);
    PanelWindow(const PanelWindow&) = delete;
    PanelWindow& operator=(const PanelWindow&) = delete;
    ~PanelWindow();

    /// False where the window is collapsed, so that nothing has to be drawn.
    explicit operator bool() const { return visible_; }

  private:
    bool visible_;
};

/// Whether time changes something in the open scene.
bool hasTimeline(const ViewModel& model);

/// The space that the panels have in this frame.
PanelSpace panelSpace(const ViewModel& model);

/// Decides where panels and picture lie in this frame: to be called before all panels are drawn.
void layPanels(ViewModel& model);
/// Draws the bars between panels and picture, and moves what is dragged.
void drawSplitters(ViewModel& model);

/// Adds an error to the model's messages, unless the last one says the same.
void addError(ViewModel& model, const char* text);

/// Runs `work`, which changes the scene or the device. What it throws becomes a message.
template <typename Work>
void tryTo(ViewModel& model, Work&& work) {
    try {
        work();
    } catch (const std::exception& error) {
        addError(model, error.what());
    }
}

/// A picture of `ViewModel::thumbnails`; 0 where it is not drawn.
inline unsigned thumbnail(const std::vector<unsigned>& pictures, std::size_t index) {
    return index < pictures.size() ? pictures[index] : 0;
}

/// A number that changes with every scene that is opened. Call it in every frame that draws panels.
std::uint64_t sceneNumber(const ViewModel& model);

/// State of a panel for the open scene, reset for each scene. The program has one window; each panel has its
/// own type `Kept`.
template <typename Kept>
Kept& keptOfScene(const ViewModel& model) {
    static std::optional<Kept> kept;
    static std::uint64_t number = 0;
    if (!kept || number != sceneNumber(model)) {
        kept.emplace();
        number = sceneNumber(model);
    }
    return *kept;
}
