#pragma once

#include "color/display_steps.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace candela {

/// A picture to show. Plain numbers only: each kernel is compiled for its own instruction set and must not
/// share inline functions with other files.
struct DisplayJob {
    const float* radiance;  ///< Four floats a pixel, rows from the bottom.
    float scale;            ///< Of the radiance, before the steps: exposure.
    int width;
    const DisplayStep* steps;
    std::size_t stepCount;
    std::uint32_t* codes;        ///< Of the lowest row: red in the lowest byte, alpha 255.
    std::ptrdiff_t rowStep;      ///< From the codes of a row to those of the row above.
    std::uint32_t left, bottom;  ///< Of the lower left pixel in the picture of which this is a part.
};

/// The functions of one instruction set.
struct DisplayKernel {
    const char* name;
    /// Writes the codes of the rows from `first` to `end`: what display.frag computes.
    void (*display)(const DisplayJob& job, int first, int end);
};

/// One for each instruction set that this build has and this processor runs, widest first.
std::vector<const DisplayKernel*> displayKernels();

}  // namespace candela
