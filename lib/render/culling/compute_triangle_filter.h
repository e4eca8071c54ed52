#pragma once

#include "gl/program.h"
#include "render/culling/triangle_filter.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace candela {

/// The triangle filter in compute shaders: nothing of it is read back. Transparent draws stay as they are,
/// since the CPU sorts them into layers.
class ComputeTriangleFilter final : public TriangleFilter {
  public:
    /// Draws of fewer triangles stay as they are. A draw of its own costs a device about as much as a
    /// thousand triangles that it sets up; instances of smaller meshes are better drawn by one command.
    static constexpr std::uint32_t minTriangles = 1024;

    /// `minDrawTriangles` is for tests.
    explicit ComputeTriangleFilter(const GpuScene::State& scene,
                                   std::uint32_t minDrawTriangles = minTriangles);

    void filter(const DrawSelection& selection, const layout::FrameUniforms& frame) override;
    /// Waits for the device.
    Counts counts() const override;

  private:
    struct Programs {
        gl::Program cull, sumBlocks, sumAll, write;
    };

    bool readsMeshes() const;
    void uploadClusters();
    void uploadDraws(const layout::FrameUniforms& frame);
    void bindStorage() const;
    void dispatch();

    std::uint32_t minIndices_;
    std::size_t maxBlock_;              ///< Bytes of a buffer that shaders read.
    std::optional<Programs> programs_;  ///< Compiled when they are first needed.
    std::vector<layout::FilterDraw> records_;
    std::uint32_t groups_ = 0;
    std::uint64_t clusterVersion_ = 0;
    gl::Buffer clusterBuffer_{"triangle clusters", gl::BufferUsage::dynamic};
    gl::Buffer drawBuffer_{"draws of the triangle filter", gl::BufferUsage::dynamic};
    gl::Buffer resultBuffer_{"clusters kept", gl::BufferUsage::device};
    gl::Buffer sumBuffer_{"triangles kept", gl::BufferUsage::device};
};

}  // namespace candela
