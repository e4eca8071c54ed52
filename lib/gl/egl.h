#pragma once

#include <candela/context.h>

#include <epoxy/egl.h>

#include <memory>
#include <string>
#include <vector>

namespace candela::gl {

/// An initialised EGL display. Contexts of one device share it; the last one to go terminates it.
class EglDisplay {
  public:
    ~EglDisplay();

    EGLDisplay handle() const { return handle_; }

    /// The display of an enumerated device, or Mesa's surfaceless one for EGL_NO_DEVICE_EXT. Throws `Error`
    /// (environment) with EGL's reason.
    static std::shared_ptr<EglDisplay> open(EGLDeviceEXT device);

  private:
    explicit EglDisplay(EGLDisplay handle) : handle_(handle) {}
    EGLDisplay handle_;
};

struct EglDevice {
    EGLDeviceEXT handle;
    Device device;
};

/// The machine's EGL devices; empty where EGL is absent or can not enumerate.
std::vector<EglDevice> enumerateEglDevices();

/// EGL's last error in words, such as "EGL_BAD_ALLOC".
std::string eglErrorName();

}  // namespace candela::gl
