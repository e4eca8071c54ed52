#pragma once

#include "render/culling/triangle_filter.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// The triangle filter on all cores of the CPU. For software devices, whose rasteriser takes all triangles
/// through one thread.
class CpuTriangleFilter final : public TriangleFilter {
  public:
    /// The meshes of `scene` can be read by the CPU (`GpuMeshes::Access`).
    explicit CpuTriangleFilter(const GpuScene::State& scene,
                               const TriangleFilterKernel& kernel = *triangleFilterKernels().front());

    void filter(const DrawSelection& selection, const layout::FrameUniforms& frame) override;
    Counts counts() const override;

  private:
    /// Clusters of a draw, for one thread.
    struct Share {
        std::size_t draw;
        ClusterRange clusters;
        std::uint32_t firstIndex, indexCount;
        std::uint32_t inKeptClusters = 0, kept = 0;  ///< Indices.
        unsigned worker = 0;                         ///< The thread that filters it.
        std::size_t place = 0;                       ///< Of its indices among those that the thread keeps.
        std::size_t out = 0;                         ///< Of its indices among all.
    };
    /// Indices that a thread has kept.
    struct Kept {
        std::vector<std::uint32_t> indices;  ///< As many as there ever were.
        std::size_t count = 0;               ///< Those of this frame.
    };

    void planShares();
    void filterShare(Share& share, unsigned worker, const FilterCamera& camera);
    void filterClusters(Share& share, const layout::FilterView& view, std::uint32_t* out) const;
    void filterVisible(Share& share, FilterTriangles& job, const IndexRange& indices,
                       std::uint32_t* out) const;
    void filterRun(Share& share, FilterTriangles& job, const IndexRange& indices, std::uint32_t* out) const;
    void gather();
    void writeCommands();

    const TriangleFilterKernel& kernel_;
    std::span<const HiddenTriangle> hidden_;  ///< Of the call in progress.
    std::vector<Share> shares_;
    std::vector<Kept> kept_;  ///< One a thread.
};

}  // namespace candela
