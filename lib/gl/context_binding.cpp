#include "gl/context_binding.h"

#include <candela/error.h>

#include <dlfcn.h>

#include <atomic>
#include <cstring>

namespace candela::gl {

namespace {

using GlxGetCurrentContext = void* (*)();

/// glXGetCurrentContext of a GLX that the process has loaded; null when it has none, and then no GLX context
/// is current. GLX is not linked: a server without X11 has no use for it.
GlxGetCurrentContext loadedGlx() {
    for (const char* library : {"libGLX.so.0", "libGL.so.1"}) {
        void* handle = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
        if (handle == nullptr) continue;
        void* function = dlsym(handle, "glXGetCurrentContext");
        dlclose(handle);  // The process keeps the library loaded.
        if (function != nullptr) return reinterpret_cast<GlxGetCurrentContext>(function);
    }
    return nullptr;
}

std::string uniqueLabel() {
    static std::atomic<std::uint64_t> count{0};
    return "candela context " + std::to_string(++count);
}

GLuint createMarker(const std::string& label) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glObjectLabel(GL_BUFFER, name, -1, label.c_str());
    return name;
}

}  // namespace

void* currentNativeContext() {
    if (void* egl = eglGetCurrentContext()) return egl;
    // A process may load GLX later, so that only a success is remembered.
    static std::atomic<GlxGetCurrentContext> known{nullptr};
    GlxGetCurrentContext getCurrent = known.load();
    if (getCurrent == nullptr) {
        getCurrent = loadedGlx();
        known.store(getCurrent);
    }
    return getCurrent != nullptr ? getCurrent() : nullptr;
}

ContextBinding::ContextBinding(std::unique_ptr<HeadlessContext> headless)
    : headless_(std::move(headless)), native_(headless_->handle()) {}

ContextBinding::ContextBinding()
    : native_(currentNativeContext()), label_(uniqueLabel()), marker_(createMarker(label_)) {}

ContextBinding::~ContextBinding() {
    if (marker_ != 0 && isSameContext()) glDeleteBuffers(1, &marker_);
}

void ContextBinding::requireCurrent(const char* user) const {
    if (isCurrent()) return;
    throw Error(ErrorKind::environment, "",
                std::string(user) + " is used while its OpenGL context is not current on this thread (" +
                    (currentNativeContext() == nullptr ? "no context is" : "another one is") + "); make " +
                    (isOwned() ? "it current with makeCurrent of its Context or Renderer"
                               : "the host's context current") +
                    " first");
}

void ContextBinding::makeCurrent() const {
    if (headless_) headless_->makeCurrent();
}

/// Is the current context this one, and not another that was created at its address?
bool ContextBinding::isSameContext() const {
    if (native_ == nullptr || !isCurrent()) return false;
    if (isOwned()) return true;
    if (glIsBuffer(marker_) == GL_FALSE) return false;
    std::array<char, 64> label{};
    glGetObjectLabel(GL_BUFFER, marker_, static_cast<GLsizei>(label.size()), nullptr, label.data());
    return label_ == label.data();
}

DestructionScope::DestructionScope(const ContextBinding& binding) {
    if (binding.isOwned() && !binding.isCurrent()) {
        previous_ = CurrentEglContext::get();
        // Fails where the context is current on another thread.
        restore_ = binding.headless_->tryMakeCurrent();
    }
    canDelete_ = binding.isSameContext();
}

DestructionScope::~DestructionScope() {
    if (restore_) previous_.makeCurrent();
}

void reportLeak(const char* owner) {
    std::fprintf(stderr,
                 "candela: a %s is destroyed while its OpenGL context is gone or not current on this thread; "
                 "its OpenGL objects are leaked\n",
                 owner);
}

}  // namespace candela::gl
