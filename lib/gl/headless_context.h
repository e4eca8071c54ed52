#pragma once

#include "gl/egl.h"

#include <memory>

namespace candela::gl {

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

  private:
    std::shared_ptr<EglDisplay> display_;
    EGLContext context_;
};

}  // namespace candela::gl
