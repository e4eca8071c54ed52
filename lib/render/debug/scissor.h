#pragma once

#include <epoxy/gl.h>

namespace candela {

/// Restricts draws and clears to a rectangle of the target, for as long as the object lives.
class Scissor {
  public:
    struct Rectangle {
        GLint x, y;
        GLsizei width, height;
    };
    explicit Scissor(const Rectangle& rectangle) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(rectangle.x, rectangle.y, rectangle.width, rectangle.height);
    }
    Scissor(const Scissor&) = delete;
    Scissor& operator=(const Scissor&) = delete;
    ~Scissor() { glDisable(GL_SCISSOR_TEST); }
};

}  // namespace candela
