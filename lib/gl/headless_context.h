#pragma once

#include "gl/egl.h"

#include <memory>

namespace candela::gl {

/// What EGL has current on a thread, to be put back later.
struct CurrentEglContext {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLSurface draw = EGL_NO_SURFACE, read = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;

    static CurrentEglContext get();
    void makeCurrent() const;
};

/// A surfaceless OpenGL 4.5 core context of an EGL display.
class HeadlessContext {
  public:
    /// Makes it and makes it current. Throws `Error` (environment) with the reason.
    explicit HeadlessContext(std::shared_ptr<EglDisplay> display);
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;
    ~HeadlessContext();

    /// Throws `Error` (environment) when EGL refuses, for instance because the context is current on another
    /// thread.
    void makeCurrent() const;
    /// The same; false when EGL refuses.
    bool tryMakeCurrent() const;

    EGLContext handle() const { return context_; }

  private:
    std::shared_ptr<EglDisplay> display_;
    EGLContext context_;
};

}  // namespace candela::gl
