#pragma once

#include "base/thread_pool.h"
#include "render/lighting/tiled/tile_kernel.h"

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// The lights of each tile of a picture, found on all cores: cull and count, prefix sum, fill.
class LightBins {
  public:
    /// Bins the frame's point and spot lights.
    void fill(const TileFrame& frame, const TileKernel& kernel, ThreadPool& pool);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    /// The lights that may reach tile `tile` (row by row from the bottom), in growing order.
    std::span<const std::uint32_t> lights(std::size_t tile) const;
    /// The tiles, those with most lights first: what is long starts early, so that all cores end together.
    std::span<const std::uint32_t> order() const { return order_; }

    std::uint32_t longest() const { return longest_; }
    std::uint64_t lightsInView() const { return inView_; }
    /// Bytes of all lists of the frame.
    std::uint64_t bytes() const;

  private:
    /// A run of lights that one worker culls; runs follow each other, so that lists stay in order.
    struct Chunk {
        std::vector<VisibleLight> visible;
        std::size_t visibleCount = 0;
        std::vector<std::uint32_t> next;  ///< A count for each tile, then where its next light goes.
    };
    void sumUp();

    int columns_ = 0, rows_ = 0;
    std::vector<Chunk> chunks_;
    std::vector<std::uint32_t> starts_, lists_, order_;
    std::uint32_t longest_ = 0;
    std::uint64_t inView_ = 0;
};

}  // namespace candela
