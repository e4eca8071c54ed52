#pragma once

#include <candela/export.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// An EGL device of this machine.
struct Device {
    int index = 0;                 ///< What `DeviceOptions::index` takes.
    std::string description = {};  ///< Its render node or "software rasteriser".
    bool software = false;
};

/// An attempt to create a context, and its outcome.
struct ContextAttempt {
    std::string way = {};      ///< Such as "EGL device 0 (/dev/dri/renderD128)".
    std::string outcome = {};  ///< The renderer's name, or why it failed.
};

/// Which device a headless context runs on. By default GPUs first, then the software device, then a
/// surfaceless display.
struct DeviceOptions {
    std::optional<int> index = {};  ///< This device and no other.
    bool softwareOnly = false;      ///< Software devices only.
};

/// The EGL devices of this machine; empty where EGL can not enumerate them.
CANDELA_API std::vector<Device> listDevices();

/// An OpenGL 4.5 core context. Everything created for a context has to be used while that context is current
/// on the calling thread; using it otherwise throws `Error` (environment). What is created for a headless
/// context keeps it alive. What is created for a host's context should be destroyed while that is current:
/// otherwise its OpenGL objects are leaked, with a line on standard error. A `Context` that was moved from
/// throws `Error` (badInput).
class CANDELA_API Context {
  public:
    /// Creates a context without a window and makes it current. Throws `Error` (environment) that lists every
    /// attempt and its reason.
    static Context createHeadless(const DeviceOptions& options = {});
    /// Takes the context that is current on this thread, of a window or any other host; it stays the host's.
    /// Throws `Error` (environment) when there is none or it is older than OpenGL 4.5.
    static Context adoptCurrent();

    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;
    ~Context();

    /// Makes a headless context current on this thread; does nothing to an adopted one, whose host does that.
    void makeCurrent() const;

    /// GL_RENDERER, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
    const std::string& renderer() const;
    /// GL_VENDOR and GL_VERSION, such as "Mesa, 4.5 (Core Profile) Mesa 22.3.6".
    const std::string& driver() const;
    /// True when the renderer runs on the CPU: the code paths that are fast there are used. False where the
    /// environment variable CANDELA_ASSUME_GPU is set, which makes tests draw as on a GPU.
    bool isSoftware() const;
    /// What was tried on the way to this context, in order; empty for an adopted one.
    const std::vector<ContextAttempt>& attempts() const;

    struct State;  ///< Private to the library.
    const State& state() const;

  private:
    explicit Context(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// A scope at whose end the context that was current on this thread before (of EGL) is current again, or none
/// where none was: another thread can then make current what was used.
class CANDELA_API CurrentContextScope {
  public:
    /// Changes nothing by itself: for scopes in which contexts are created.
    CurrentContextScope();
    /// Makes a headless context current; does nothing to an adopted one. Throws `Error` (environment) when
    /// EGL refuses, such as where the context is current on another thread.
    explicit CurrentContextScope(const Context& context);
    CurrentContextScope(const CurrentContextScope&) = delete;
    CurrentContextScope& operator=(const CurrentContextScope&) = delete;
    ~CurrentContextScope();

  private:
    struct Previous;
    std::unique_ptr<Previous> previous_;  ///< None where there is nothing to put back.
};

}  // namespace candela
