#include "render/lighting/tiled/light_bins.h"

#include <algorithm>
#include <numeric>

namespace candela {

namespace {

/// Fewer lights are binned by one worker: starting the others takes longer.
constexpr std::uint32_t minLightsForThreads = 1024;
/// Several a worker, since lights in view take longer than others and may follow each other.
constexpr std::uint32_t chunksPerWorker = 4;

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

std::size_t LightBins::tileCount() const {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
}

void LightBins::count(const TileFrame& frame, std::uint32_t first, std::uint32_t end,
                      const TileKernel& kernel, ThreadPool& pool) {
    const std::uint32_t lights = end - first;
    const std::uint32_t chunks = lights < minLightsForThreads ? 1 : pool.size() * chunksPerWorker;
    const std::uint32_t perChunk = (lights + chunks - 1) / chunks;
    chunks_.resize(chunks);
    // All memory is allocated here: the loop body allocates nothing.
    for (std::uint32_t c = 0; c < chunks; ++c) {
        Chunk& chunk = chunks_[c];
        chunk.first = first + std::min(c * perChunk, lights);
        chunk.end = first + std::min((c + 1) * perChunk, lights);
        const std::size_t size = chunk.end - chunk.first;
        if (chunk.room < size) {
            chunk.visible = std::make_unique_for_overwrite<VisibleLight[]>(size);
            chunk.room = size;
        }
        chunk.next.resize(tileCount());
    }
    pool.run(chunks, [&](std::size_t c, unsigned) {
        Chunk& chunk = chunks_[c];
        chunk.visibleCount = kernel.cull(frame, chunk.first, chunk.end, chunk.visible.get());
        std::ranges::fill(chunk.next, 0u);
        for (std::size_t i = 0; i < chunk.visibleCount; ++i)
            forEachTile(chunk.visible[i], columns_, [&](std::size_t tile) { ++chunk.next[tile]; });
    });
}

std::uint64_t LightBins::wordsNeeded(std::size_t workers) const {
    std::uint64_t sum = 0, longest = 0;
    for (std::size_t tile = 0; tile < tileCount(); ++tile) {
        std::uint64_t length = 0;
        for (const Chunk& chunk : chunks_) length += chunk.next[tile];
        sum += length;
        longest = std::max(longest, length);
    }
    return sum + longest * scratchWordsPerLight * workers;
}

std::uint32_t LightBins::fill(const TileFrame& frame, std::uint32_t first, const TileKernel& kernel,
                              ThreadPool& pool) {
    columns_ = (frame.width + tileSize - 1) / tileSize;
    rows_ = (frame.height + tileSize - 1) / tileSize;
    std::uint32_t lights = frame.localCount - first;
    for (;;) {
        count(frame, first, first + lights, kernel, pool);
        const std::uint64_t words = wordsNeeded(pool.size());
        if (words <= maxWords_ || lights <= 1) break;
        // Less than all of them, since maxWords_ < words.
        const double part = static_cast<double>(maxWords_) / static_cast<double>(words);
        lights = std::max(1u, static_cast<std::uint32_t>(lights * part));
    }
    sumUp();
    pool.run(chunks_.size(), [&](std::size_t c, unsigned) {
        Chunk& chunk = chunks_[c];
        for (std::size_t i = 0; i < chunk.visibleCount; ++i) {
            const VisibleLight& light = chunk.visible[i];
            forEachTile(light, columns_, [&](std::size_t tile) { lists_[chunk.next[tile]++] = light.index; });
        }
    });
    return first + lights;
}

void LightBins::sumUp() {
    const std::size_t tiles = tileCount();
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
