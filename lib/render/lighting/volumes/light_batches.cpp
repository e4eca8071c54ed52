#include "render/lighting/volumes/light_batches.h"

#include <algorithm>
#include <array>
#include <bit>

namespace candela {

namespace {

int cellOf(float share, int cells) {
    return std::clamp(static_cast<int>(share * static_cast<float>(cells)), 0, cells - 1);
}

}  // namespace

std::uint32_t LightBatches::freeBatch(const Frustum::Rectangle& bounds) {
    const int left = cellOf(bounds.min.x, columns_), right = cellOf(bounds.max.x, columns_);
    const int bottom = cellOf(bounds.min.y, rows_), top = cellOf(bounds.max.y, rows_);
    std::array<std::uint64_t, batchWords> used{};
    const auto words = [&](int column, int row) {
        return taken_.data() + (static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                                static_cast<std::size_t>(column)) *
                                   batchWords;
    };
    for (int row = bottom; row <= top; ++row) {
        for (int column = left; column <= right; ++column) {
            const std::uint64_t* cell = words(column, row);
            for (std::uint32_t w = 0; w < batchWords; ++w) used[w] |= cell[w];
        }
    }
    const auto word =
        std::ranges::find_if(used, [](std::uint64_t bits) { return bits != ~std::uint64_t{0}; });
    if (word == used.end()) return batchWords * 64;
    const auto w = static_cast<std::uint32_t>(word - used.begin());
    const auto bit = static_cast<std::uint32_t>(std::countr_one(*word));
    for (int row = bottom; row <= top; ++row) {
        for (int column = left; column <= right; ++column) words(column, row)[w] |= std::uint64_t{1} << bit;
    }
    return w * 64 + bit;
}

void LightBatches::assign(const Input& input) {
    columns_ = (input.width + cellSize - 1) / cellSize;
    rows_ = (input.height + cellSize - 1) / cellSize;
    taken_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) * batchWords, 0);
    for (auto& batch : batches_) batch.clear();
    unsorted_.clear();
    // A pixel's rectangle is a cell's at least: bounds are widened by one pixel for the rasteriser's
    // rounding.
    const glm::vec2 pixel = 1.0f / glm::vec2(input.width, input.height);
    for (std::size_t i = input.first; i < input.end; ++i) {
        const glm::vec3 center = input.reaches.position(i);
        const float range = input.reaches.range[i], radius = range * input.proxyRadius;
        if (!input.frustum.meets(center, range)) continue;
        const auto light = static_cast<std::uint32_t>(i);
        if (input.frustum.meetsNearPlane(center, radius)) {
            unsorted_.push_back(light);
            continue;
        }
        Frustum::Rectangle bounds = input.frustum.projectedBounds(center, radius);
        const std::uint32_t batch = freeBatch({bounds.min - pixel, bounds.max + pixel});
        if (batch == batchWords * 64) {
            unsorted_.push_back(light);
            continue;
        }
        if (batch >= batches_.size()) batches_.resize(batch + 1);
        batches_[batch].push_back(light);
    }
    lights_.clear();
    ends_.clear();
    for (const auto& batch : batches_) {
        if (batch.empty()) break;
        lights_.insert(lights_.end(), batch.begin(), batch.end());
        ends_.push_back(static_cast<std::uint32_t>(lights_.size()));
    }
    lights_.insert(lights_.end(), unsorted_.begin(), unsorted_.end());
}

}  // namespace candela
