#pragma once

#include "gl/framebuffer.h"
#include "gl/texture.h"

#include <candela/frame_data.h>
#include <candela/frame_settings.h>

#include <cstdint>
#include <span>
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

/// The radiance of a frame as hosts get it, from `rgba` and reversed depth with rows from the bottom.
HdrImage wholeRadiance(int width, int height, std::vector<float> rgba, std::span<const float> depth);

/// Reverses the order of the rows of RGBA pixels.
void flipRows(std::vector<float>& rgba, int width, int height);
void flipRows(std::vector<std::uint8_t>& rgba, int width, int height);

}  // namespace candela
