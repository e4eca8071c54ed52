#pragma once

#include <candela/export.h>
#include <candela/frame_data.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace candela {

/// The radiance of mid-grey: what a display shows as the middle between black and white.
constexpr double midGrey = 0.18;

/// What the pixels of a frame show, counted.
struct ExposureCounts {
    std::uint64_t surfaces = 0;  ///< Pixels on which a surface is.
    std::uint64_t lit = 0;       ///< Of those, pixels of a luminance over 0.
    std::uint64_t overBlack =
        0;  ///< Of those, pixels that an 8-bit sRGB display shows over black, after the exposure.
    std::uint64_t overWhite = 0;  ///< Of those, pixels of a luminance over 1 after the exposure.
};

/// Counts the pixels of a frame. `luminanceWeights` are those of `ColorConfig::luminanceWeights`; `exposure`
/// is in stops, as in `DisplayOptions`. Throws `Error` (badInput) when the image does not hold width × height
/// × 4 values.
CANDELA_API ExposureCounts countExposure(const HdrImage& radiance, const glm::vec3& luminanceWeights,
                                         double exposure);

/// The exposure, in stops, at which the median luminance of all lit pixels of `frames` is `midGrey`; -100 to
/// 100. None where no pixel is lit. Throws as `countExposure`.
CANDELA_API std::optional<double> autoExposure(std::span<const HdrImage> frames,
                                               const glm::vec3& luminanceWeights);

}  // namespace candela
