#include "gl/framebuffer.h"

#include <candela/error.h>

#include <string>

namespace candela::gl {

void deleteFramebuffer(GLuint name) {
    glDeleteFramebuffers(1, &name);
}

namespace {

GLuint createFramebuffer(const char* label) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    glObjectLabel(GL_FRAMEBUFFER, name, -1, label);
    return name;
}

GLenum depthAttachment(const Texture& depth) {
    GLint format = 0;
    glGetTextureLevelParameteriv(depth.name(), 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    const bool stencil = format == GL_DEPTH32F_STENCIL8 || format == GL_DEPTH24_STENCIL8;
    return stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
}

}  // namespace

Framebuffer::Framebuffer(const std::vector<const Texture*>& colors, const Texture* depth, const char* label)
    : object_(createFramebuffer(label)) {
    std::vector<GLenum> buffers;
    for (const Texture* color : colors) {
        const auto attachment = static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + buffers.size());
        buffers.push_back(color != nullptr ? attachment : GL_NONE);
        if (color != nullptr) glNamedFramebufferTexture(name(), attachment, color->name(), 0);
    }
    glNamedFramebufferDrawBuffers(name(), static_cast<GLsizei>(buffers.size()), buffers.data());
    if (depth != nullptr) glNamedFramebufferTexture(name(), depthAttachment(*depth), depth->name(), 0);
    if (glCheckNamedFramebufferStatus(name(), GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw Error(ErrorKind::environment, "",
                    std::string("this device can not draw into the framebuffer '") + label + "'");
    }
}

}  // namespace candela::gl
