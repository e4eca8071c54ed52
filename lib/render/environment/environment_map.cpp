#include "render/environment/environment_map.h"

#include "base/thread_pool.h"
#include "render/instruction_sets.h"
#include "render/layout.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

namespace candela {

extern const EnvironmentKernel environmentKernelBaseline;
#if defined(__x86_64__)
extern const EnvironmentKernel environmentKernelAvx2, environmentKernelAvx512;
#endif

std::vector<const EnvironmentKernel*> environmentKernels() {
    std::vector<const EnvironmentKernel*> kernels;
#if defined(__x86_64__)
    if (widestInstructionSet() >= InstructionSet::avx512) kernels.push_back(&environmentKernelAvx512);
    if (widestInstructionSet() >= InstructionSet::avx2) kernels.push_back(&environmentKernelAvx2);
#endif
    kernels.push_back(&environmentKernelBaseline);
    return kernels;
}

const EnvironmentKernel& environmentKernel() {
    static const EnvironmentKernel& widest = *environmentKernels().front();
    return widest;
}

namespace {

/// Texels along a side of the levels that are filtered. The lobe's full width at half maximum, 2.6 alpha, is
/// that of at least two texels; of one for the last level, whose texels take most of the time.
constexpr std::array<int, EnvironmentMap::levelCount - 1> filteredSizes{63, 63,  63,  63, 63,
                                                                        95, 159, 255, 319};
constexpr int irradianceSize = 159;
constexpr int peakTexels = 2;

/// Texels along a side of the level that is not filtered: about those of the picture.
int sharpSize(std::uint32_t pictureHeight) {
    constexpr std::uint32_t least = 256, most = 2048;
    return static_cast<int>(std::clamp(std::bit_ceil(pictureHeight), least, most)) - 1;
}

glm::vec3 directionOf(int column, int row, int size) {
    const glm::vec2 at = 2.0f * glm::vec2(column, row) / static_cast<float>(size - 1) - 1.0f;
    const float y = 1.0f - std::abs(at.x) - std::abs(at.y), below = std::max(-y, 0.0f);
    return {at.x - std::copysign(below, at.x), y, at.y - std::copysign(below, at.y)};
}

/// Calls `fill` for each row of blocks of a map with `size` texels along a side, with room for the cells of a
/// grid of `finestSize` cells along a side.
void runBlocks(int size, int finestSize, const std::function<void(int, const EnvironmentCell**)>& fill) {
    const std::size_t room = static_cast<std::size_t>(finestSize) * static_cast<std::size_t>(finestSize) + 1;
    ThreadPool& pool = *ThreadPool::shared();
    std::vector<std::vector<const EnvironmentCell*>> scratch(pool.size());
    pool.run(static_cast<std::size_t>((size + filterBlockSize - 1) / filterBlockSize),
             [&](std::size_t row, unsigned worker) {
                 scratch[worker].resize(room);
                 fill(static_cast<int>(row), scratch[worker].data());
             });
}

}  // namespace

EnvironmentMap::EnvironmentMap(const Image& picture, const glm::dmat3& workingFromRec709,
                               const EnvironmentKernel& kernel) {
    static_assert(layout::ENVIRONMENT_LEVELS == levelCount);
    static_assert(layout::ENVIRONMENT_HEADER ==
                  layout::ENVIRONMENT_PEAKS + peakTexels * static_cast<int>(maxEnvironmentPeaks));
    const EnvironmentPicture source(picture, workingFromRec709);
    texels_.resize(4 * std::size_t{layout::ENVIRONMENT_HEADER});
    irradiance_ = append(irradianceSize);
    for (std::size_t i = 0; i < filteredSizes.size(); ++i) levels_[i] = append(filteredSizes[i]);
    levels_.back() = append(sharpSize(picture.height));
    resample(source);
    const EnvironmentCells cells(source);
    for (int i = 0; i < levelCount - 1; ++i) filterLevel(i, cells, kernel);
    const DiffuseLight light(cells);
    peaks_ = light.peaks;
    fillIrradiance(light, cells, kernel);
    writeHeader();
}

OctahedralMap EnvironmentMap::append(int size) {
    const OctahedralMap map{texels_.size() / 4, size};
    texels_.resize(texels_.size() + 4 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    return map;
}

float* EnvironmentMap::texelsOf(const OctahedralMap& map) {
    return texels_.data() + 4 * map.first;
}

void EnvironmentMap::filterLevel(int index, const EnvironmentCells& cells, const EnvironmentKernel& kernel) {
    const OctahedralMap& map = level(index);
    const float alpha = std::exp2(-static_cast<float>(index));
    // Narrow lobes gather most of their light from the finest cells.
    const float cellShare = map.size <= 63 ? 0.2f : map.size <= 159 ? 0.35f : 0.7f;
    const FilterJob job{
        cells.grids().data(), static_cast<int>(cells.grids().size()), alpha, cellShare, map.size,
        texelsOf(map)};
    runBlocks(map.size, EnvironmentCells::finestSize,
              [&](int row, const EnvironmentCell** scratch) { kernel.filter(job, row, scratch); });
}

/// Texels that mirror each other about the middle of the map have the same angles but for signs.
void EnvironmentMap::resample(const EnvironmentPicture& picture) {
    const OctahedralMap& map = levels_.back();
    const int last = map.size - 1;
    float* first = texelsOf(map);
    ThreadPool::shared()->run(static_cast<std::size_t>(last / 2 + 1), [&](std::size_t line, unsigned) {
        const int row = static_cast<int>(line);
        const auto write = [&](int toColumn, int toRow, const glm::vec3& radiance) {
            float* texel = first + 4 * (toRow * map.size + toColumn);
            for (int i = 0; i < 3; ++i) texel[i] = radiance[i];
        };
        for (int column = 0; column <= last / 2; ++column) {
            // x and z are 0 or negative here.
            const PicturePoint point = picture.pointOf(directionOf(column, row, map.size));
            write(column, row, picture.interpolated(point));
            write(last - column, row, picture.interpolated({1.0f - point.x, point.y}));
            const float across = 0.5f - point.x;  // From the middle column's quarter to the border's.
            write(column, last - row, picture.interpolated({across, point.y}));
            write(last - column, last - row, picture.interpolated({1.0f - across, point.y}));
        }
    });
}

void EnvironmentMap::fillIrradiance(const DiffuseLight& light, const EnvironmentCells& cells,
                                    const EnvironmentKernel& kernel) {
    constexpr int size = DiffuseLight::size;
    const IrradianceJob job{cells.gridOf(size / 4),
                            {light.cells.data(), size},
                            cells.gridOf(2 * size),
                            irradianceSize,
                            texelsOf(irradiance_)};
    runBlocks(irradianceSize, 2 * size,
              [&](int row, const EnvironmentCell** scratch) { kernel.irradiance(job, row, scratch); });
}

void EnvironmentMap::writeHeader() {
    const auto write = [&](int texel, const glm::vec3& value) {
        for (int i = 0; i < 3; ++i) texels_[static_cast<std::size_t>(4 * texel + i)] = value[i];
    };
    // Below 2^24, so that a float holds it.
    const auto describe = [&](int texel, const OctahedralMap& map) {
        write(texel, {map.first, map.size, 0});
    };
    for (int i = 0; i < levelCount; ++i) describe(i, level(i));
    describe(layout::ENVIRONMENT_IRRADIANCE, irradiance_);
    write(layout::ENVIRONMENT_PEAK_COUNT, glm::vec3(static_cast<float>(peaks_.size())));
    int texel = layout::ENVIRONMENT_PEAKS;
    for (const EnvironmentPeak& peak : peaks_) {
        write(texel, peak.direction), write(texel + 1, peak.irradiance);
        texels_[static_cast<std::size_t>(4 * texel + 3)] = peak.halfWidth;
        texel += peakTexels;
    }
}

}  // namespace candela
