#include "gl/headless_context.h"

#include <candela/error.h>

#include <cstring>
#include <utility>

namespace candela::gl {

namespace {

void require(EGLDisplay display, const char* extension) {
    const char* all = eglQueryString(display, EGL_EXTENSIONS);
    if (all == nullptr || std::strstr(all, extension) == nullptr) {
        throw Error(ErrorKind::environment, "", std::string("the EGL display lacks ") + extension);
    }
}

EGLContext createContext(EGLDisplay display) {
    require(display, "EGL_KHR_surfaceless_context");
    require(display, "EGL_KHR_no_config_context");
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) {
        throw Error(ErrorKind::environment, "", "the EGL display offers no OpenGL (" + eglErrorName() + ")");
    }
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT) {
        throw Error(ErrorKind::environment, "",
                    "the device gives no OpenGL 4.5 core context (" + eglErrorName() + ")");
    }
    return context;
}

}  // namespace

CurrentEglContext CurrentEglContext::get() {
    return {eglGetCurrentDisplay(), eglGetCurrentSurface(EGL_DRAW), eglGetCurrentSurface(EGL_READ),
            eglGetCurrentContext()};
}

void CurrentEglContext::makeCurrent() const {
    // EGL releases the current context through any initialised display.
    const EGLDisplay through = display != EGL_NO_DISPLAY ? display : eglGetCurrentDisplay();
    if (through != EGL_NO_DISPLAY) eglMakeCurrent(through, draw, read, context);
}

HeadlessContext::HeadlessContext(std::shared_ptr<EglDisplay> display)
    : display_(std::move(display)), context_(createContext(display_->handle())) {
    try {
        makeCurrent();
    } catch (...) {
        eglDestroyContext(display_->handle(), context_);
        throw;
    }
}

HeadlessContext::~HeadlessContext() {
    if (eglGetCurrentContext() == context_) {
        eglMakeCurrent(display_->handle(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display_->handle(), context_);
}

bool HeadlessContext::tryMakeCurrent() const {
    return eglMakeCurrent(display_->handle(), EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
}

void HeadlessContext::makeCurrent() const {
    if (!tryMakeCurrent()) {
        throw Error(ErrorKind::environment, "",
                    "the OpenGL context can not be made current (" + eglErrorName() + ")");
    }
}

}  // namespace candela::gl
