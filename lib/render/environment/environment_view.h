#pragma once

#include <cstdint>

namespace candela {

/// An environment as the kernels of `tiles` read it. Plain numbers only: see `TileFrame`.
struct EnvironmentView {
    static constexpr int levelCount = 10;

    const float* texels;  ///< RGBA: see `EnvironmentMap`.
    /// The first texel of each level, and its texels along a side.
    float firstTexels[levelCount], sizes[levelCount];
    float irradianceFirst, irradianceSize;  ///< The same of the irradiance.
    const float* peaks;  ///< Eight floats each: direction and half width, irradiance and 0.
    int peakCount;
    float axes[3][3];  ///< Rows of the rotation from the world to the picture's frame.
    float intensity;
};

}  // namespace candela
