#include "gl/egl.h"

#include <candela/error.h>

#include <dlfcn.h>

#include <cstring>
#include <map>
#include <mutex>

namespace candela::gl {

namespace {

bool isInstalled(const char* library) {
    // Never closed: libepoxy opens the same one.
    return dlopen(library, RTLD_LAZY | RTLD_LOCAL) != nullptr;
}

/// libepoxy ends the process where it does not find these libraries.
void requireLibraries() {
    static const bool hasEgl = isInstalled("libEGL.so.1");
    static const bool hasOpenGL = isInstalled("libOpenGL.so.0") || isInstalled("libGL.so.1");
    if (!hasEgl || !hasOpenGL) {
        throw Error(ErrorKind::environment, "",
                    std::string(hasEgl ? "libOpenGL.so.0 and libGL.so.1 are" : "libEGL.so.1 is") +
                        " not installed; on Debian, the packages libegl1, libgl1 and libgl1-mesa-dri bring "
                        "what contexts need");
    }
}

bool clientHas(const char* extension) {
    requireLibraries();
    const char* all = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    return all != nullptr && std::strstr(all, extension) != nullptr;
}

EGLDisplay displayHandle(EGLDeviceEXT device) {
    if (!clientHas("EGL_EXT_platform_base"))
        throw Error(ErrorKind::environment, "", "EGL offers no platform displays");
    // The EXT entry: libepoxy can resolve the core one only after a display is current.
    return device == EGL_NO_DEVICE_EXT
               ? eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr)
               : eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
}

EglDevice describe(EGLDeviceEXT handle, int index) {
    const char* text = eglQueryDeviceStringEXT(handle, EGL_EXTENSIONS);
    const std::string extensions = text != nullptr ? text : "";
    EglDevice device{handle, {index, "", extensions.find("EGL_MESA_device_software") != std::string::npos}};
    if (device.device.software) {
        device.device.description = "software rasteriser";
    } else if (extensions.find("EGL_EXT_device_drm") != std::string::npos) {
        const char* node = eglQueryDeviceStringEXT(handle, EGL_DRM_DEVICE_FILE_EXT);
        device.device.description = node != nullptr ? node : "GPU";
    } else {
        device.device.description = "GPU";
    }
    return device;
}

}  // namespace

std::string eglErrorName() {
    switch (eglGetError()) {
        case EGL_SUCCESS:
            return "no error";
        case EGL_NOT_INITIALIZED:
            return "EGL_NOT_INITIALIZED";
        case EGL_BAD_ACCESS:
            return "EGL_BAD_ACCESS";
        case EGL_BAD_ALLOC:
            return "EGL_BAD_ALLOC";
        case EGL_BAD_ATTRIBUTE:
            return "EGL_BAD_ATTRIBUTE";
        case EGL_BAD_CONFIG:
            return "EGL_BAD_CONFIG";
        case EGL_BAD_CONTEXT:
            return "EGL_BAD_CONTEXT";
        case EGL_BAD_DISPLAY:
            return "EGL_BAD_DISPLAY";
        case EGL_BAD_MATCH:
            return "EGL_BAD_MATCH";
        case EGL_BAD_PARAMETER:
            return "EGL_BAD_PARAMETER";
        default:
            return "an unknown EGL error";
    }
}

namespace {

/// The displays that are initialised. One handle may have two `EglDisplay` objects for a moment: the last
/// owner of one is on its way to the destructor while another thread opens the display again.
struct OpenDisplays {
    struct Entry {
        std::weak_ptr<EglDisplay> display;
        int objects = 0;
    };
    std::mutex mutex;
    std::map<EGLDisplay, Entry> entries;
};

OpenDisplays& openDisplays() {
    static OpenDisplays displays;
    return displays;
}

}  // namespace

EglDisplay::~EglDisplay() {
    OpenDisplays& displays = openDisplays();
    const std::lock_guard lock(displays.mutex);
    if (--displays.entries[handle_].objects > 0) return;
    displays.entries.erase(handle_);
    eglTerminate(handle_);
}

std::shared_ptr<EglDisplay> EglDisplay::open(EGLDeviceEXT device) {
    OpenDisplays& displays = openDisplays();
    const std::lock_guard lock(displays.mutex);
    const EGLDisplay handle = displayHandle(device);
    if (handle == EGL_NO_DISPLAY)
        throw Error(ErrorKind::environment, "", "EGL gives no display (" + eglErrorName() + ")");
    const auto found = displays.entries.find(handle);
    if (found != displays.entries.end()) {
        if (auto shared = found->second.display.lock()) return shared;
    }
    if (eglInitialize(handle, nullptr, nullptr) == EGL_FALSE) {
        throw Error(ErrorKind::environment, "",
                    "the EGL display does not initialise (" + eglErrorName() + ")");
    }
    std::shared_ptr<EglDisplay> display(new EglDisplay(handle));
    OpenDisplays::Entry& entry = displays.entries[handle];
    entry.display = display;
    ++entry.objects;
    return display;
}

std::vector<EglDevice> enumerateEglDevices() {
    std::vector<EglDevice> devices;
    if (!clientHas("EGL_EXT_device_enumeration") && !clientHas("EGL_EXT_device_base")) return devices;
    EGLint count = 0;
    if (eglQueryDevicesEXT(0, nullptr, &count) == EGL_FALSE || count <= 0) return devices;
    std::vector<EGLDeviceEXT> handles(static_cast<std::size_t>(count));
    eglQueryDevicesEXT(count, handles.data(), &count);
    for (int i = 0; i < count; ++i) devices.push_back(describe(handles[static_cast<std::size_t>(i)], i));
    return devices;
}

}  // namespace candela::gl
