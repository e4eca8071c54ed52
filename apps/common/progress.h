#pragma once

#include <string>

enum class Verbosity { normal, quiet };

/// One line on standard error that says what goes on: only on a terminal, and only when not quiet. Nothing
/// of it stays when the work is done.
class Progress {
  public:
    explicit Progress(Verbosity verbosity);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    /// Replaces the line.
    void show(const std::string& text);
    /// Takes the line away, so that something else can be printed.
    void clear();

  private:
    bool enabled_;
    std::string shown_;
};
