#include "host_context.h"

#include <utility>

namespace candela::test {

HostContext::HostContext(int major, int minor)
    : display_(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr)) {
    eglInitialize(display_, nullptr, nullptr);
    eglBindAPI(EGL_OPENGL_API);
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 major,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 minor,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 EGL_TRUE,
                                 EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (!valid()) return;
    makeCurrent();
    if (epoxy_gl_version() < 43) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(&HostContext::report, this);
}

HostContext::~HostContext() {
    if (!valid()) return;
    if (eglGetCurrentContext() == context_) release();
    eglDestroyContext(display_, context_);
}

void HostContext::makeCurrent() const {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
}

void HostContext::release() const {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

std::vector<std::string> HostContext::takeErrors() {
    if (const GLenum error = glGetError()) errors_.push_back("glGetError gives " + std::to_string(error));
    return std::exchange(errors_, {});
}

void HostContext::report(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message,
                         const void* user) {
    if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) return;
    static_cast<HostContext*>(const_cast<void*>(user))->errors_.emplace_back(message);
}

}  // namespace candela::test
