#include "render/lighting/volumes/stencilled_depth.h"

#include "render/layout.h"

namespace candela {

StencilledDepth::StencilledDepth()
    : copy_({{"fullscreen_triangle.vert", {}, {}}, {"depth_copy.frag", {}, {}}}, "depth copy"),
      vertexArray_("depth copy") {}

void StencilledDepth::resize(const GBufferTargets& targets, const gl::Texture& color) {
    if (sized_ && sized_->width == targets.width && sized_->height == targets.height &&
        sized_->color == color.name())
        return;
    gl::Texture texture =
        gl::Texture::target2d(GL_DEPTH32F_STENCIL8, targets.width, targets.height, "depth and stencil");
    gl::Framebuffer framebuffer({&color}, &texture, "light volumes");
    sized_ = Sized{targets.width, targets.height, color.name(), std::move(texture), std::move(framebuffer)};
}

void StencilledDepth::bind(const GBufferTargets& targets, const gl::Texture& color) {
    resize(targets, color);
    const GLuint name = sized_->framebuffer.name();
    glClearNamedFramebufferfi(name, GL_DEPTH_STENCIL, 0, 0.0f, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
    glViewport(0, 0, targets.width, targets.height);
    glUseProgram(copy_.name());
    glBindVertexArray(vertexArray_.name());
    glBindTextureUnit(layout::DEPTH_UNIT, targets.depth.name());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace candela
