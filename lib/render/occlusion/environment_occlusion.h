#pragma once

#include "render/layout.h"
#include "render/occlusion/occlusion_view.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// The rays of a frame that ask how much of the environment each pixel sees.
struct EnvironmentRays {
    std::uint32_t rays;    ///< At each pixel.
    std::uint32_t sample;  ///< `FrameSettings::sample`.
    float distance;        ///< Metres: what is farther hides nothing.
};

/// What they start from: whole targets of `frame.size` pixels, rows from the bottom.
struct EnvironmentOcclusionInputs {
    const layout::FrameUniforms& frame;
    std::span<const float> depth;             ///< Reversed.
    std::span<const std::uint32_t> surfaces;  ///< Two words a pixel: `GBufferTexel`.
    std::span<const std::uint32_t> shadowWords;
    std::span<const std::uint8_t>
        textures;  ///< What occlusion textures leave, 255 is 1; empty: nothing has one.
    const OcclusionView& occluders;
    EnvironmentRays rays;
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
    /// A pixel as the filter reads it.
    struct Sample {
        glm::vec3 geometricNormal;
        float viewDistance;  ///< 0 where there is no surface.
    };
    struct Tile;

    void trace(const EnvironmentOcclusionInputs& inputs, std::span<const glm::vec3> directions, int left,
               int bottom);
    void filterRow(const EnvironmentOcclusionInputs& inputs, int y);
    float hiddenAt(const EnvironmentOcclusionInputs& inputs, int x, int y) const;

    std::vector<Sample> samples_;
    std::vector<float> hidden_;  ///< The share of each pixel's rays that do not arrive.
    std::vector<std::uint8_t> visibility_;
};

}  // namespace candela
