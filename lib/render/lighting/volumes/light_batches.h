#pragma once

#include "render/frustum.h"
#include "render/gpu_scene/gpu_lights.h"

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// Sorts the volumes of lights into batches in which no two overlap on the screen, so that one stencil value
/// can serve all volumes of a batch in one draw.
class LightBatches {
  public:
    struct Input {
        const LightReaches& reaches;
        std::size_t first, end;  ///< The lights of `reaches` to take.
        const Frustum& frustum;
        float proxyRadius;  ///< How far the volume's polyhedron reaches, in ranges.
        int width, height;  ///< Of the picture, pixels.
    };

    /// Assigns the lights in view. Lights whose volume reaches the near plane, and those beyond the last
    /// batch, come out as `unsorted`.
    void assign(const Input& input);

    /// The lights of batch 0, then those of batch 1, and so on, then the unsorted ones.
    std::span<const std::uint32_t> lights() const { return lights_; }
    /// Where in `lights` each batch ends.
    std::span<const std::uint32_t> batchEnds() const { return ends_; }

  private:
    static constexpr std::uint32_t batchWords = 16;  ///< 1,024 batches at most.
    static constexpr int cellSize = 32;              ///< Pixels: the grain at which overlap is seen.

    std::uint32_t freeBatch(const Frustum::Rectangle& bounds);

    int columns_ = 0, rows_ = 0;
    std::vector<std::uint64_t> taken_;  ///< A bit for each batch in each cell.
    std::vector<std::vector<std::uint32_t>> batches_;
    std::vector<std::uint32_t> unsorted_, lights_, ends_;
};

}  // namespace candela
