#pragma once

#include "base/thread_pool.h"
#include "render/lighting/tiled/tile_kernel.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace candela {

/// The lights of each tile of a picture, binned on all cores: cull and count, prefix sum, fill.
class LightBins {
  public:
    /// The lists hold at most `maxWords` 32-bit words in all, the memory of the workers that walk them
    /// included, unless a single light needs more.
    explicit LightBins(std::uint64_t maxWords) : maxWords_(maxWords) {}

    /// Bins the frame's point and spot lights from `first` on, as many as the lists hold. Returns the end of
    /// the binned lights: where it is less than `frame.localCount`, the caller shades them and bins the rest.
    std::uint32_t fill(const TileFrame& frame, std::uint32_t first, const TileKernel& kernel,
                       ThreadPool& pool);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    /// The lights that may reach tile `tile` (row by row from the bottom), sorted.
    std::span<const std::uint32_t> lights(std::size_t tile) const;
    /// The tiles, those with the longest lists first: long work starts early, so that all cores end together.
    std::span<const std::uint32_t> order() const { return order_; }

    /// The length of the longest list.
    std::uint32_t longest() const { return longest_; }
    /// Bytes of all lists.
    std::uint64_t bytes() const;

  private:
    /// Consecutive lights that one worker culls. Chunks follow each other, so that lists stay sorted.
    struct Chunk {
        std::uint32_t first = 0, end = 0;
        /// Room for all of them; only what is written takes memory.
        std::unique_ptr<VisibleLight[]> visible;
        std::size_t room = 0, visibleCount = 0;
        std::vector<std::uint32_t> next;  ///< For each tile the count, then the position of its next light.
    };

    void count(const TileFrame& frame, std::uint32_t first, std::uint32_t end, const TileKernel& kernel,
               ThreadPool& pool);
    /// The words that the lists of the counted lights need.
    std::uint64_t wordsNeeded(std::size_t workers) const;
    void sumUp();
    std::size_t tileCount() const;

    std::uint64_t maxWords_;
    int columns_ = 0, rows_ = 0;
    std::vector<Chunk> chunks_;
    std::vector<std::uint32_t> starts_, lists_, order_;
    std::uint32_t longest_ = 0;
};

}  // namespace candela
