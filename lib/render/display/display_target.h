#pragma once

#include "gl/framebuffer.h"
#include "gl/texture.h"

#include <candela/frame_settings.h>

#include <cstdint>
#include <vector>

namespace candela {

/// An 8-bit picture that is read back.
struct DisplayTarget {
    DisplayTarget(int width, int height);
    /// The pixels, rows from the top.
    std::vector<std::uint8_t> read() const;

    int width, height;
    gl::Texture texture;
    gl::Framebuffer framebuffer;
};

/// Throws `Error` (badInput) unless the framebuffer exists and can be drawn into: OpenGL itself would only
/// leave an error in the host's queue.
void requireTarget(const FrameTarget& target);

/// Reverses the order of the rows of RGBA pixels.
void flipRows(std::vector<float>& rgba, int width, int height);
void flipRows(std::vector<std::uint8_t>& rgba, int width, int height);

}  // namespace candela
