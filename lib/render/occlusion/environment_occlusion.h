#pragma once

#include "gl/framebuffer.h"
#include "render/layout.h"
#include "render/occlusion/hemisphere_block.h"
#include "render/occlusion/occlusion_view.h"
#include "render/occlusion/visibility_filter.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

struct TileFrame;

/// The rays of a frame that ask how much of the environment each pixel sees.
struct EnvironmentRays {
    std::uint32_t rays;    ///< At each pixel.
    std::uint32_t sample;  ///< `FrameSettings::sample`.
    float distance;        ///< Metres: what is farther hides nothing.
};

/// What they start from: targets of `frame.size` pixels, rows from the bottom. Surfaces lie in `rectangle`,
/// four pixels or more from those of its sides that are not the targets'; what is outside is not read.
struct EnvironmentOcclusionInputs {
    const layout::FrameUniforms& frame;
    std::span<const float> depth;             ///< Reversed.
    std::span<const std::uint32_t> surfaces;  ///< Two words a pixel: `GBufferTexel`.
    std::span<const std::uint32_t> shadowWords;
    std::span<const std::uint8_t>
        textures;  ///< What occlusion textures leave, 255 is 1; empty: nothing has one.
    const OcclusionView& occluders;
    EnvironmentRays rays;
    gl::PixelRectangle rectangle;
};

/// How much of the environment each pixel sees, by Embree on all threads of the library; the result depends
/// on their number in no bit. Directions are those of shaders/shared/environment_ray.h around the shading
/// normal. A filter of 4 × 4 pixels averages what neighbours on one surface have found. Shaders do the same
/// (render/occlusion/environment_occlusion_pass.h).
class EnvironmentOcclusion {
  public:
    /// One byte a pixel, 255 is all; undefined where there is no surface. Valid until the next call.
    std::span<const std::uint8_t> compute(const EnvironmentOcclusionInputs& inputs);

  private:
    /// The pixels as `VisibilityFilterJob` has them.
    struct Surfaces {
        std::array<std::vector<float>, 3> normal;    ///< The triangle's; 0 where there is no surface.
        std::array<std::vector<float>, 3> position;  ///< From the eye, metres.
        std::vector<float> extent;                   ///< The side of a pixel, metres; 0 as above.
        std::vector<float> hidden;                   ///< The share of the rays that do not arrive.

        void resize(std::size_t pixels);
        void set(std::size_t pixel, const HemisphereBlock& block, int lane, float hiddenShare);
    };

    void trace(const EnvironmentOcclusionInputs& inputs, const TileFrame& frame,
               std::span<const glm::vec3> directions, int left, int bottom);
    VisibilityFilterJob filterJob(const EnvironmentOcclusionInputs& inputs);

    Surfaces surfaces_;
    std::vector<std::uint8_t> visibility_;
};

}  // namespace candela
