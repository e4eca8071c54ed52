#pragma once

#include "gl/buffer.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "render/gbuffer/gbuffer_targets.h"

#include <optional>

namespace candela {

/// A copy of the G-buffer's depth beside a stencil, and a framebuffer of it with a colour target. The
/// G-buffer itself has no stencil, which would cost every other technique a third more memory traffic.
class StencilledDepth {
  public:
    StencilledDepth();

    /// Copies the depth, clears the stencil to 0, and binds a framebuffer of both with `color`.
    void bind(const GBufferTargets& targets, const gl::Texture& color);

  private:
    struct Sized {
        int width, height;
        GLuint color;  ///< The texture's name that the framebuffer was made with.
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    void resize(const GBufferTargets& targets, const gl::Texture& color);

    gl::Program copy_;
    gl::VertexArray vertexArray_;
    std::optional<Sized> sized_;
};

}  // namespace candela
