#include "render/environment/environment_cells.h"

#include "base/thread_pool.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>

namespace candela {

namespace {

constexpr double pi = std::numbers::pi;

/// The number of points along each side of a texel of the picture.
struct Oversampling {
    std::uint32_t x, y;
};

Oversampling oversamplingOf(const EnvironmentPicture& picture) {
    constexpr std::uint32_t minWidth = 2048, minHeight = 1024;
    const auto factor = [](std::uint32_t least, std::uint32_t size) { return (least + size - 1) / size; };
    return {factor(minWidth, picture.width()), factor(minHeight, picture.height())};
}

float sum(const glm::vec3& color) {
    return color.r + color.g + color.b;
}

/// About the mean radiance, all channels together: of one texel in 16 or more.
float meanRadiance(const EnvironmentPicture& picture) {
    const std::uint32_t stepX = picture.width() / 512 + 1, stepY = picture.height() / 256 + 1;
    double total = 0.0, count = 0.0;
    for (std::uint32_t row = stepY / 2; row < picture.height(); row += stepY) {
        for (std::uint32_t column = stepX / 2; column < picture.width(); column += stepX) {
            total += static_cast<double>(sum(picture.texel(column, row)));
            ++count;
        }
    }
    return static_cast<float>(total / count);
}

void add(EnvironmentCell& to, const EnvironmentCell& cell) {
    for (int i = 0; i < 3; ++i) to.direction[i] += cell.direction[i], to.energy[i] += cell.energy[i];
    to.solidAngle += cell.solidAngle;
}

std::vector<EnvironmentCell> coarser(const std::vector<EnvironmentCell>& fine, int size) {
    const int half = size / 2;
    std::vector<EnvironmentCell> cells(static_cast<std::size_t>(half) * static_cast<std::size_t>(half));
    ThreadPool::shared()->run(static_cast<std::size_t>(half), [&](std::size_t line, unsigned) {
        const int top = 2 * static_cast<int>(line);
        for (int row = top; row < top + 2; ++row) {
            for (int column = 0; column < size; ++column)
                add(cells[line * static_cast<std::size_t>(half) + static_cast<std::size_t>(column / 2)],
                    fine[static_cast<std::size_t>(row * size + column)]);
        }
    });
    return cells;
}

/// Moments become directions. Where a direction is one of the octahedron's, times a number, the area of a
/// cell grows with the cube of that number: its side with the power 3/2.
void finish(EnvironmentCell& cell, int size) {
    float* d = cell.direction;
    const float length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    if (length <= 0.0f) return;
    for (int i = 0; i < 3; ++i) d[i] /= length;
    const float scale = std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]);
    cell.side = 2.0f / static_cast<float>(size) * scale * std::sqrt(scale);
}

}  // namespace

EnvironmentCells::EnvironmentCells(const EnvironmentPicture& picture) {
    cells_.emplace_back(std::size_t{finestSize} * finestSize);
    // The middle of a dark cell is that of its area.
    const float mean = meanRadiance(picture);
    const float floor = mean > 0.0f ? 1.0e-4f * mean : 1.0f;
    ThreadPool& pool = *ThreadPool::shared();
    pool.run(
        4, [&](std::size_t quadrant, unsigned) { addQuadrant(picture, static_cast<int>(quadrant), floor); });
    for (int size = finestSize; size > coarsestSize; size /= 2)
        cells_.push_back(coarser(cells_.back(), size));
    std::ranges::reverse(cells_);
    int size = coarsestSize;
    for (std::vector<EnvironmentCell>& grid : cells_) {
        pool.run(static_cast<std::size_t>(size), [&](std::size_t row, unsigned) {
            for (int column = 0; column < size; ++column)
                finish(grid[row * static_cast<std::size_t>(size) + static_cast<std::size_t>(column)], size);
        });
        grids_.push_back({grid.data(), size});
        size *= 2;
    }
}

const CellGrid& EnvironmentCells::gridOf(int size) const {
    return *std::ranges::find(grids_, size, &CellGrid::size);
}

/// Adds the columns of a quarter of the picture. Each has the cells of a quarter of the grid to itself: the
/// borders of both are where x and z change their signs.
void EnvironmentCells::addQuadrant(const EnvironmentPicture& picture, int quadrant, float floor) {
    const Oversampling factor = oversamplingOf(picture);
    const std::uint32_t width = picture.width() * factor.x, height = picture.height() * factor.y;
    const auto firstOf = [&](int part) {
        return static_cast<std::uint32_t>(std::uint64_t{width} * static_cast<unsigned>(part) / 4);
    };
    const bool right = quadrant >= 2, toNegativeZ = quadrant == 1 || quadrant == 2;
    constexpr int half = finestSize / 2;
    const auto cellOf = [&](float x, float z) {
        const int across = std::min(static_cast<int>(x * half), half - 1),
                  along = std::min(static_cast<int>(z * half), half - 1);
        const int column = right ? half + across : half - 1 - across,
                  row = toNegativeZ ? half - 1 - along : half + along;
        return static_cast<std::size_t>(row * finestSize + column);
    };
    const std::uint32_t first = firstOf(quadrant), end = firstOf(quadrant + 1);
    std::vector<glm::vec2> azimuths;
    for (std::uint32_t column = first; column < end; ++column) {
        const double angle = 2.0 * pi * ((column + 0.5) / width - 0.5);
        azimuths.emplace_back(std::abs(std::sin(angle)), std::abs(std::cos(angle)));
    }
    for (std::uint32_t row = 0; row < height; ++row) {
        const double angle = pi * (row + 0.5) / height;
        const auto across = static_cast<float>(std::sin(angle)), y = static_cast<float>(std::cos(angle));
        const auto solidAngle = static_cast<float>(
            2.0 * pi / width * (std::cos(pi * row / height) - std::cos(pi * (row + 1.0) / height)));
        const float below = std::max(-y, 0.0f);
        for (std::uint32_t column = first; column < end; ++column) {
            const glm::vec2 side = across * azimuths[column - first];
            const float scale = 1.0f / (side.x + side.y + std::abs(y));
            const glm::vec3 radiance =
                factor.x == 1 && factor.y == 1
                    ? picture.texel(column, row)
                    : picture.interpolated({(static_cast<float>(column) + 0.5f) / static_cast<float>(width),
                                            (static_cast<float>(row) + 0.5f) / static_cast<float>(height)});
            const float weight = solidAngle * (sum(radiance) + floor);
            EnvironmentCell cell{};
            cell.direction[0] = (right ? side.x : -side.x) * weight;
            cell.direction[1] = y * weight;
            cell.direction[2] = (toNegativeZ ? -side.y : side.y) * weight;
            cell.solidAngle = solidAngle;
            for (int i = 0; i < 3; ++i) cell.energy[i] = radiance[i] * solidAngle;
            add(cells_[0][cellOf((side.x + below) * scale, (side.y + below) * scale)], cell);
        }
    }
}

namespace {

glm::vec3 directionOf(const EnvironmentCell& cell) {
    return {cell.direction[0], cell.direction[1], cell.direction[2]};
}

glm::vec3 energyOf(const EnvironmentCell& cell) {
    return {cell.energy[0], cell.energy[1], cell.energy[2]};
}

float lightOf(const EnvironmentCell& cell) {
    return sum(energyOf(cell));
}

/// Moves the light of the brightest cells that lie together out of `cells`, where it is more than `least` and
/// comes from a small source.
std::optional<EnvironmentPeak> takePeak(std::vector<EnvironmentCell>& cells, float least) {
    constexpr float radius = 0.12f, cellShare = 0.1f;
    // 1 - |sum of vectors| / sum of lengths, of a disc of radius 0.05.
    constexpr float mostSpread = 0.05f * 0.05f / 4.0f;
    const EnvironmentCell brightest = *std::ranges::max_element(cells, {}, lightOf);
    std::vector<EnvironmentCell*> cluster;
    glm::vec3 irradiance(0.0f), vector(0.0f);
    for (EnvironmentCell& cell : cells) {
        if (lightOf(cell) < cellShare * lightOf(brightest) ||
            glm::distance(directionOf(cell), directionOf(brightest)) > radius)
            continue;
        cluster.push_back(&cell);
        irradiance += energyOf(cell);
        vector += directionOf(cell) * lightOf(cell);
    }
    if (sum(irradiance) <= least || 1.0f - glm::length(vector) / sum(irradiance) > mostSpread)
        return std::nullopt;
    for (EnvironmentCell* cell : cluster) std::ranges::fill(cell->energy, 0.0f);
    return EnvironmentPeak{glm::normalize(vector), irradiance};
}

/// A disc of radius r has a variance of r² / 4 along an axis, an even spread from -h to h one of h² / 3. Only
/// cells of a tenth of the brightest one's radiance count.
float halfWidthOf(const EnvironmentPeak& peak, const CellGrid& grid) {
    constexpr float radius = 0.06f, least = 1.0e-3f;
    std::vector<const EnvironmentCell*> near;
    float brightest = 0.0f;
    for (const EnvironmentCell& cell :
         std::span(grid.cells, std::size_t(grid.size) * std::size_t(grid.size))) {
        if (cell.solidAngle <= 0.0f || glm::distance(directionOf(cell), peak.direction) > radius) continue;
        near.push_back(&cell);
        brightest = std::max(brightest, lightOf(cell) / cell.solidAngle);
    }
    float variance = 0.0f, light = 0.0f;
    for (const EnvironmentCell* cell : near) {
        if (lightOf(*cell) < 0.1f * brightest * cell->solidAngle) continue;
        const float distance = glm::distance(directionOf(*cell), peak.direction);
        variance += 0.5f * distance * distance * lightOf(*cell);
        light += lightOf(*cell);
    }
    return light > 0.0f ? std::max(std::sqrt(3.0f * variance / light), least) : least;
}

}  // namespace

DiffuseLight::DiffuseLight(const EnvironmentCells& source) {
    const CellGrid& grid = source.gridOf(size);
    cells.assign(grid.cells, grid.cells + size * size);
    constexpr float leastShare = 0.05f;
    float total = 0.0f;
    for (const EnvironmentCell& cell : cells) total += lightOf(cell);
    while (peaks.size() < maxEnvironmentPeaks) {
        const std::optional<EnvironmentPeak> peak = takePeak(cells, leastShare * total);
        if (!peak) break;
        peaks.push_back(*peak);
        peaks.back().halfWidth = halfWidthOf(*peak, source.grids().back());
    }
}

}  // namespace candela
