#include "render/environment/environment_map.h"

#include "base/thread_pool.h"
#include "render/layout.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace candela {

extern const EnvironmentKernel environmentKernelBaseline;
#if defined(__x86_64__)
extern const EnvironmentKernel environmentKernelAvx2, environmentKernelAvx512;
#endif

std::vector<const EnvironmentKernel*> environmentKernels() {
    std::vector<const EnvironmentKernel*> kernels;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
        kernels.push_back(&environmentKernelAvx512);
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        kernels.push_back(&environmentKernelAvx2);
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
constexpr std::array<int, EnvironmentMap::levelCount - 1> filteredSizes{64, 64,  64,  64, 64,
                                                                        96, 160, 256, 320};
constexpr int irradianceSize = 160;
constexpr int peakTexels = 2;

/// Texels along a side of the level that is not filtered: about those of the picture.
int sharpSize(std::uint32_t pictureHeight) {
    constexpr std::uint32_t least = 256, most = 2048;
    return static_cast<int>(std::clamp(std::bit_ceil(pictureHeight), least, most));
}

glm::vec3 directionOf(int column, int row, int size) {
    const glm::vec2 at = (2.0f * glm::vec2(column, row) + 1.0f) / static_cast<float>(size) - 1.0f;
    const float y = 1.0f - std::abs(at.x) - std::abs(at.y), below = std::max(-y, 0.0f);
    return {at.x - std::copysign(below, at.x), y, at.y - std::copysign(below, at.y)};
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
    fillIrradiance(light.grid(), kernel);
    for (const OctahedralMap& map : levels_) fillBorder(map);
    fillBorder(irradiance_);
    writeHeader();
}

OctahedralMap EnvironmentMap::append(int size) {
    const OctahedralMap map{texels_.size() / 4, size};
    const std::size_t stride = static_cast<std::size_t>(size) + 2;
    texels_.resize(texels_.size() + 4 * stride * stride);
    return map;
}

/// The first texel that is not border.
float* EnvironmentMap::inner(const OctahedralMap& map) {
    return texels_.data() + 4 * (map.first + static_cast<std::size_t>(map.size) + 3);
}

void EnvironmentMap::filterLevel(int index, const EnvironmentCells& cells, const EnvironmentKernel& kernel) {
    const OctahedralMap& map = level(index);
    const float alpha = std::exp2(-static_cast<float>(index));
    // Narrow lobes gather most of their light from the finest cells.
    const float cellShare = map.size <= 64 ? 0.2f : map.size <= 160 ? 0.35f : 0.7f;
    const FilterJob job{
        cells.grids().data(), static_cast<int>(cells.grids().size()), alpha, cellShare, map.size, inner(map),
        map.size + 2};
    ThreadPool& pool = *ThreadPool::shared();
    std::vector<std::vector<const EnvironmentCell*>> scratch(pool.size());
    pool.run(static_cast<std::size_t>(map.size / filterBlockSize), [&](std::size_t row, unsigned worker) {
        scratch[worker].resize(std::size_t{EnvironmentCells::finestSize} * EnvironmentCells::finestSize + 1);
        kernel.filter(job, static_cast<int>(row), scratch[worker].data());
    });
}

/// Texels that mirror each other about the middle of the map have the same angles but for signs.
void EnvironmentMap::resample(const EnvironmentPicture& picture) {
    const OctahedralMap& map = levels_.back();
    const int last = map.size - 1, stride = map.size + 2;
    float* first = inner(map);
    ThreadPool::shared()->run(static_cast<std::size_t>(map.size / 2), [&](std::size_t line, unsigned) {
        const int row = static_cast<int>(line);
        const auto write = [&](int toColumn, int toRow, const glm::vec3& radiance) {
            float* texel = first + 4 * (toRow * stride + toColumn);
            for (int i = 0; i < 3; ++i) texel[i] = radiance[i];
        };
        for (int column = 0; column <= last / 2; ++column) {
            // x and z are negative here.
            const PicturePoint point = picture.pointOf(directionOf(column, row, map.size));
            write(column, row, picture.interpolated(point));
            write(last - column, row, picture.interpolated({1.0f - point.x, point.y}));
            const float across = 0.5f - point.x;  // From the middle column's quarter to the border's.
            write(column, last - row, picture.interpolated({across, point.y}));
            write(last - column, last - row, picture.interpolated({1.0f - across, point.y}));
        }
    });
}

void EnvironmentMap::fillIrradiance(const CellGrid& grid, const EnvironmentKernel& kernel) {
    const IrradianceJob job{grid, irradianceSize, inner(irradiance_), irradianceSize + 2};
    ThreadPool::shared()->run(
        irradianceSize, [&](std::size_t row, unsigned) { kernel.irradiance(job, static_cast<int>(row)); });
}

/// Beyond an edge, the map goes on with the texels of the same edge, mirrored about its middle.
void EnvironmentMap::fillBorder(const OctahedralMap& map) {
    const int last = map.size - 1, stride = map.size + 2;
    float* first = inner(map);
    const auto copy = [&](int column, int row, int fromColumn, int fromRow) {
        std::copy_n(first + 4 * (fromRow * stride + fromColumn), 4, first + 4 * (row * stride + column));
    };
    for (int i = 0; i <= last; ++i) {
        copy(-1, i, 0, last - i), copy(last + 1, i, last, last - i);
        copy(i, -1, last - i, 0), copy(i, last + 1, last - i, last);
    }
    copy(-1, -1, last, last), copy(last + 1, last + 1, 0, 0);
    copy(last + 1, -1, 0, last), copy(-1, last + 1, last, 0);
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
