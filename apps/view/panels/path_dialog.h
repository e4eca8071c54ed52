#pragma once

#include <string>

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
