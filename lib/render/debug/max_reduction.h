#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"

namespace candela {

/// The greatest value of a picture, found on the GPU.
class MaxReduction {
  public:
    MaxReduction();

    /// Finds it among the first components of `picture`, which has the frame's size and no value below 0, and
    /// leaves it bound for shaders/lib/greatest.glsl.
    void find(const gl::Texture& picture, int width, int height);
    /// What `find` found last. Waits for it.
    float value() const;

  private:
    gl::Program program_;
    gl::Buffer buffer_;
};

}  // namespace candela
