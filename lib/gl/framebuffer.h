#pragma once

#include "gl/object.h"
#include "gl/texture.h"

#include <vector>

namespace candela::gl {

void deleteFramebuffer(GLuint name);

/// A rectangle of pixels, y from the bottom.
struct PixelRectangle {
    int x = 0, y = 0, width = 0, height = 0;

    bool operator==(const PixelRectangle&) const = default;
};

/// Restricts draws and clears to a rectangle of the target for its lifetime.
class Scissor {
  public:
    explicit Scissor(const PixelRectangle& rectangle) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(rectangle.x, rectangle.y, rectangle.width, rectangle.height);
    }
    Scissor(const Scissor&) = delete;
    Scissor& operator=(const Scissor&) = delete;
    ~Scissor() { glDisable(GL_SCISSOR_TEST); }
};

/// A framebuffer with textures attached.
class Framebuffer {
  public:
    Framebuffer() = default;
    /// `colors` become attachments 0, 1, ... and the draw buffers; null leaves an output without one. `depth`
    /// may be null; a depth format with stencil is attached as both.
    Framebuffer(const std::vector<const Texture*>& colors, const Texture* depth, const char* label);

    GLuint name() const { return object_.name(); }

  private:
    Object<deleteFramebuffer> object_;
};

}  // namespace candela::gl
