#pragma once

#include <atomic>
#include <filesystem>
#include <thread>

/// Tells when a file of a folder, or of the folders in it, has changed. Waits without using the CPU.
class ShaderWatch {
  public:
    /// Watches the folder that CANDELA_SHADER_DIR names, if it is set; else nothing ever changes. `wake` is
    /// called from a thread of its own. Throws `candela::Error` (environment) when the folder can not be
    /// watched.
    explicit ShaderWatch(void (*wake)());
    ShaderWatch(const ShaderWatch&) = delete;
    ShaderWatch& operator=(const ShaderWatch&) = delete;
    ~ShaderWatch();

    /// Has something changed since the last call?
    bool takeChange() { return changed_.exchange(false); }

  private:
    void add(const std::filesystem::path& folder);
    void wait();

    void (*wake_)();
    int events_ = -1, stop_ = -1;
    std::atomic<bool> changed_{false};
    std::thread thread_;
};
