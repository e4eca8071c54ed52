#pragma once

#include "render/environment/environment_cells.h"

#include <candela/image.h>

#include <glm/mat3x3.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace candela {

/// The kernel for the widest instruction set that this processor has.
const EnvironmentKernel& environmentKernel();

/// An octahedral map among the texels of an `EnvironmentMap`: size² texels, row by row. The outer ones lie
/// on the edges of the square, and those of an odd size on its axes: where the interpolation between four
/// texels has a fold. The
/// middle of the square is +Y, its corners are -Y, columns follow x and rows follow z.
struct OctahedralMap {
    std::size_t first = 0;  ///< Texel.
    int size = 0;           ///< Texels along a side, odd.
};

/// An environment as surfaces read it, in the frame of its picture and in the working space; neither rotation
/// nor intensity is in it. docs/environment.md says how it is made, and what it is off by.
class EnvironmentMap {
  public:
    /// Level i below the last is the radiance that a lobe of alpha = 2^-i gathers around a direction; the
    /// last one is that of the direction itself.
    static constexpr int levelCount = 10;

    /// Filters the picture, which `validate` accepts. Runs on all threads of the library.
    EnvironmentMap(const Image& picture, const glm::dmat3& workingFromRec709,
                   const EnvironmentKernel& kernel = environmentKernel());

    const OctahedralMap& level(int index) const { return levels_[static_cast<std::size_t>(index)]; }
    /// Irradiance by normal, without that of the peaks.
    const OctahedralMap& irradiance() const { return irradiance_; }
    const std::vector<EnvironmentPeak>& peaks() const { return peaks_; }

    /// RGBA. Before the maps, for shaders, stand ENVIRONMENT_HEADER texels: the first texel and the size of
    /// each level and of the irradiance, the number of peaks, and the peaks.
    std::span<const float> texels() const { return texels_; }

  private:
    OctahedralMap append(int size);
    float* texelsOf(const OctahedralMap& map);
    void filterLevel(int index, const EnvironmentCells& cells, const EnvironmentKernel& kernel);
    void resample(const EnvironmentPicture& picture);
    void fillIrradiance(const DiffuseLight& light, const EnvironmentCells& cells,
                        const EnvironmentKernel& kernel);
    void writeHeader();

    std::array<OctahedralMap, levelCount> levels_;
    OctahedralMap irradiance_;
    std::vector<EnvironmentPeak> peaks_;
    std::vector<float> texels_;
};

}  // namespace candela
