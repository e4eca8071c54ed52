#pragma once

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <string>
#include <vector>

namespace candela::test {

/// A context that a host creates by its own EGL code, without candela: a surfaceless debug context that
/// collects the errors the driver reports.
class HostContext {
  public:
    /// Asks EGL for OpenGL `major`.`minor` core and makes it current. `valid()` is false when EGL refuses.
    HostContext(int major, int minor);
    HostContext(const HostContext&) = delete;
    HostContext& operator=(const HostContext&) = delete;
    ~HostContext();

    bool valid() const { return context_ != EGL_NO_CONTEXT; }
    void makeCurrent() const;
    void release() const;

    /// What the driver reported as an error or undefined behaviour since the last call, and glGetError's
    /// pending error.
    std::vector<std::string> takeErrors();

  private:
    static void GLAPIENTRY report(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                  const GLchar* message, const void* user);

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    std::vector<std::string> errors_;
};

}  // namespace candela::test
