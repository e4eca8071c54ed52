#pragma once

#include "panels/layout.h"

/// The window of one panel, while it lives. Its first place is that of layout.h.
class PanelWindow {
  public:
    /// `open` turns false when the user closes the window.
    PanelWindow(Panel panel, const char* title, bool& open);
    PanelWindow(const PanelWindow&) = delete;
    PanelWindow& operator=(const PanelWindow&) = delete;
    ~PanelWindow();

    /// Is there anything to draw? Not where it is collapsed.
    explicit operator bool() const { return visible_; }

  private:
    bool visible_;
};

/// The space that the panels have in this frame.
PanelSpace panelSpace();

/// Every panel goes back to its first place in this frame; `endArrangement` is called once all are drawn.
void beginArrangement();
void endArrangement();
