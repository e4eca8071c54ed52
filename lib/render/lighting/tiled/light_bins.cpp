#include "render/lighting/tiled/light_bins.h"

#include <algorithm>
#include <numeric>

namespace candela {

namespace {

template <typename Visit>
void forEachTile(const VisibleLight& light, int columns, Visit visit) {
    for (int y = light.bottom; y <= light.top; ++y) {
        for (int x = light.left; x <= light.right; ++x) {
            visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(x));
        }
    }
}

}  // namespace

void LightBins::fill(const TileFrame& frame, const TileKernel& kernel, ThreadPool& pool) {
    columns_ = (frame.width + tileSize - 1) / tileSize;
    rows_ = (frame.height + tileSize - 1) / tileSize;
    const std::size_t tiles = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    const std::uint32_t chunks = frame.localCount < 1024 ? 1 : pool.size();
    chunks_.resize(chunks);
    const std::uint64_t perChunk = (frame.localCount + chunks - 1) / chunks;
    pool.run(chunks, [&](std::size_t c, unsigned) {
        Chunk& chunk = chunks_[c];
        const auto first =
            static_cast<std::uint32_t>(std::min<std::uint64_t>(c * perChunk, frame.localCount));
        const auto end =
            static_cast<std::uint32_t>(std::min<std::uint64_t>(first + perChunk, frame.localCount));
        if (chunk.visible.size() < end - first) chunk.visible.resize(end - first);
        chunk.visibleCount = kernel.cull(frame, first, end, chunk.visible.data());
        chunk.next.assign(tiles, 0);
        for (std::size_t i = 0; i < chunk.visibleCount; ++i) {
            forEachTile(chunk.visible[i], columns_, [&](std::size_t tile) { ++chunk.next[tile]; });
        }
    });
    sumUp();
    pool.run(chunks, [&](std::size_t c, unsigned) {
        Chunk& chunk = chunks_[c];
        for (std::size_t i = 0; i < chunk.visibleCount; ++i) {
            const VisibleLight& light = chunk.visible[i];
            forEachTile(light, columns_, [&](std::size_t tile) { lists_[chunk.next[tile]++] = light.index; });
        }
    });
}

void LightBins::sumUp() {
    const std::size_t tiles = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    starts_.resize(tiles + 1);
    std::uint32_t sum = 0;
    longest_ = 0;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        starts_[tile] = sum;
        for (Chunk& chunk : chunks_) {
            const std::uint32_t count = chunk.next[tile];
            chunk.next[tile] = sum;
            sum += count;
        }
        longest_ = std::max(longest_, sum - starts_[tile]);
    }
    starts_[tiles] = sum;
    if (lists_.size() < sum) lists_.resize(sum);
    inView_ = 0;
    for (const Chunk& chunk : chunks_) inView_ += chunk.visibleCount;
    order_.resize(tiles);
    std::iota(order_.begin(), order_.end(), 0u);
    std::ranges::stable_sort(order_, std::ranges::greater{},
                             [&](std::uint32_t tile) { return starts_[tile + 1] - starts_[tile]; });
}

std::span<const std::uint32_t> LightBins::lights(std::size_t tile) const {
    return std::span(lists_).subspan(starts_[tile], starts_[tile + 1] - starts_[tile]);
}

std::uint64_t LightBins::bytes() const {
    return (std::uint64_t{starts_.back()} + starts_.size()) * sizeof(std::uint32_t);
}

}  // namespace candela
