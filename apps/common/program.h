#pragma once

#include <candela/error.h>

#include <functional>
#include <stdexcept>
#include <string>

/// The command line is wrong: exit code 2. The text names the option, the value given, and what is expected.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Runs a program's work and returns its exit code: 0 done; 1 the input or the environment is at fault, with
/// one line on standard error; 2 wrong usage (`UsageError`), likewise. `name` is the program's.
int runProgram(const char* name, const std::function<void()>& work);

/// Calls `upload`, which makes a device's copy of a scene. Limits that the scene exceeds, and what is wrong
/// with it, become errors of the file `scene`.
template <typename Upload>
auto uploading(const std::string& scene, const Upload& upload) {
    try {
        return upload();
    } catch (const candela::Error& error) {
        const bool isOfTheScene =
            error.kind() == candela::ErrorKind::limit || error.kind() == candela::ErrorKind::badInput;
        if (!isOfTheScene || !error.path().empty()) throw;
        throw candela::Error(error.kind(), scene, error.what());
    }
}

enum class Verbosity { normal, quiet };

/// One line on standard error that shows the current work: only on a terminal, and only when not quiet. The
/// line is erased when the work is done.
class Progress {
  public:
    explicit Progress(Verbosity verbosity);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    /// Replaces the line.
    void show(const std::string& text);
    /// Erases the line, so that something else can be printed.
    void clear();

  private:
    bool enabled_;
    std::string shown_;
};
