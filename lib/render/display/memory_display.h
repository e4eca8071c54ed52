#pragma once

#include "render/display/display_kernel.h"
#include "render/display/display_target.h"

#include <candela/color.h>
#include <candela/frame_settings.h>

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// Radiance in memory, four floats a pixel, rows from the bottom.
struct MemoryPicture {
    std::span<const float> radiance;
    int width, height;
    glm::ivec2 place{0, 0};  ///< As in `DisplayPass::Inputs`.
};

/// Shows radiance that is in memory through a display transform, as `DisplayPass` shows a texture: vector
/// code on all cores computes the codes.
class MemoryDisplay {
  public:
    explicit MemoryDisplay(const DisplayKernel& kernel = *displayKernels().front());

    /// 8-bit RGBA, rows from the top. Uses no OpenGL.
    std::vector<std::uint8_t> codes(const MemoryPicture& picture, const DisplayTransform& transform) const;

    /// Whether `render` shows in the target what the shader would: it has one colour buffer, without
    /// multisampling, in which codes of 8 bits lose nothing. The target is complete.
    static bool suits(const FrameTarget& target);
    /// Copies codes right into a target that is an RGBA8 texture; into another one, or where the picture
    /// reaches beyond its edges, by way of a texture of its own.
    void render(const MemoryPicture& picture, const DisplayTransform& transform, const FrameTarget& target);

  private:
    const DisplayKernel* kernel_;
    std::vector<std::uint32_t> codes_;     ///< Rows from the bottom.
    std::optional<DisplayTarget> source_;  ///< Its own texture; made when it is first needed.
};

}  // namespace candela
