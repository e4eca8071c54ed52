#pragma once

#include "gl/object.h"
#include "gl/texture.h"

#include <vector>

namespace candela::gl {

void deleteFramebuffer(GLuint name);

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
