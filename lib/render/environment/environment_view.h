#pragma once

#include <cstdint>

namespace candela {

/// An environment as the kernels of `tiles` read it. Plain numbers only: see `TileFrame`.
struct EnvironmentView {
    static constexpr int levelCount = 10;

    /// An octahedral map of an `EnvironmentMap`.
    struct Map {
        const float* texels;  ///< RGBA, the border included.
        int size;             ///< Without the border.
    };
    Map levels[levelCount];
    Map irradiance;
    const float* peaks;  ///< Eight floats each: direction and 0, irradiance and 0.
    int peakCount;
    float axes[3][3];  ///< Rows of the rotation from the world to the picture's frame.
    float intensity;
};

}  // namespace candela
