#include <candela/context.h>

#include "gl/context_binding.h"

#include <candela/error.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace candela {

namespace {

/// GL_RENDERER of the current context. Throws where it is older than OpenGL 4.5.
std::string checkedRenderer() {
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const std::string renderer = name != nullptr ? name : "unknown renderer";
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor < 45) {
        throw Error(ErrorKind::environment, "",
                    "candela needs OpenGL 4.5, and this context (" + renderer + ") offers " +
                        std::to_string(major) + "." + std::to_string(minor));
    }
    return renderer;
}

/// GL_VENDOR and GL_VERSION of the current context.
std::string driverName() {
    const auto* vendor = reinterpret_cast<const char*>(glGetString(GL_VENDOR));
    const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    return std::string(vendor != nullptr ? vendor : "unknown vendor") + ", " +
           (version != nullptr ? version : "unknown version");
}

bool softwareName(const std::string& renderer) {
    constexpr std::array names{"llvmpipe", "softpipe", "SwiftShader", "Software Rasterizer"};
    return std::ranges::any_of(names,
                               [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

struct Candidate {
    std::string way;
    EGLDeviceEXT handle;
};

std::string wayOf(const Device& device) {
    return "EGL device " + std::to_string(device.index) + " (" + device.description + ")";
}

/// What the options allow, GPUs first, then software devices, then the surfaceless display.
std::vector<Candidate> candidates(const DeviceOptions& options) {
    std::vector<gl::EglDevice> devices = gl::enumerateEglDevices();
    if (options.index) {
        const auto found =
            std::ranges::find(devices, *options.index, [](const gl::EglDevice& d) { return d.device.index; });
        if (found == devices.end()) {
            throw Error(ErrorKind::environment, "",
                        "there is no EGL device " + std::to_string(*options.index) + "; this machine has " +
                            std::to_string(devices.size()) + ", counted from 0");
        }
        return {{wayOf(found->device), found->handle}};
    }
    std::ranges::stable_sort(devices, {}, [](const gl::EglDevice& d) { return d.device.software; });
    std::vector<Candidate> result;
    for (const gl::EglDevice& device : devices) {
        if (options.softwareOnly && !device.device.software) continue;
        result.push_back({wayOf(device.device), device.handle});
    }
    result.push_back({"EGL surfaceless display", EGL_NO_DEVICE_EXT});
    return result;
}

std::string failureText(const std::vector<ContextAttempt>& attempts) {
    std::string text = "no OpenGL 4.5 context can be created without a window.";
    for (const ContextAttempt& attempt : attempts) text += " " + attempt.way + ": " + attempt.outcome + ".";
    return text;
}

}  // namespace

Context Context::createHeadless(const DeviceOptions& options) {
    auto state = std::make_unique<State>();
    for (const Candidate& candidate : candidates(options)) {
        try {
            auto headless = std::make_unique<gl::HeadlessContext>(gl::EglDisplay::open(candidate.handle));
            state->renderer = checkedRenderer();
            if (options.softwareOnly && !softwareName(state->renderer)) {
                throw Error(ErrorKind::environment, "",
                            "it is not a software rasteriser but " + state->renderer);
            }
            state->driver = driverName();
            state->binding = std::make_shared<gl::ContextBinding>(std::move(headless));
            state->attempts.push_back({candidate.way, state->renderer});
            return Context(std::move(state));
        } catch (const Error& error) {
            state->attempts.push_back({candidate.way, error.what()});
        }
    }
    throw Error(ErrorKind::environment, "", failureText(state->attempts));
}

Context Context::adoptCurrent() {
    // libepoxy ends the process when asked for anything while no context is current, except for this string.
    if (eglGetCurrentContext() == EGL_NO_CONTEXT && glGetString(GL_VERSION) == nullptr) {
        throw Error(ErrorKind::environment, "", "no OpenGL context is current on this thread");
    }
    auto state = std::make_unique<State>();
    state->renderer = checkedRenderer();
    state->driver = driverName();
    state->binding = std::make_shared<gl::ContextBinding>();
    return Context(std::move(state));
}

Context::Context(std::unique_ptr<State> state) : state_(std::move(state)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

const Context::State& Context::state() const {
    if (!state_) throw Error(ErrorKind::badInput, "", "a Context is used that was moved from");
    return *state_;
}

void Context::makeCurrent() const {
    state().binding->makeCurrent();
}

const std::string& Context::renderer() const {
    return state().renderer;
}

const std::string& Context::driver() const {
    return state().driver;
}

bool Context::isSoftware() const {
    return softwareName(state().renderer) && std::getenv("CANDELA_ASSUME_GPU") == nullptr;
}

const std::vector<ContextAttempt>& Context::attempts() const {
    return state().attempts;
}

struct CurrentContextScope::Previous {
    gl::CurrentEglContext context = gl::CurrentEglContext::get();
};

CurrentContextScope::CurrentContextScope() : previous_(std::make_unique<Previous>()) {}

CurrentContextScope::CurrentContextScope(const Context& context) {
    const gl::ContextBinding& binding = *context.state().binding;
    if (!binding.isOwned() || binding.isCurrent()) return;
    auto previous = std::make_unique<Previous>();
    binding.makeCurrent();
    previous_ = std::move(previous);
}

CurrentContextScope::~CurrentContextScope() {
    if (previous_) previous_->context.makeCurrent();
}

std::vector<Device> listDevices() {
    std::vector<Device> devices;
    for (const gl::EglDevice& device : gl::enumerateEglDevices()) devices.push_back(device.device);
    return devices;
}

}  // namespace candela
