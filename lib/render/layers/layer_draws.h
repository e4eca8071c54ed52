#pragma once

#include "gl/buffer.h"
#include "render/culling/triangle_filter.h"
#include "render/gpu_scene/gpu_scene_state.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// The draws of each layer: those of the transparent surfaces in view that have a fragment in it. Without
/// them every layer would draw all surfaces, n² of a stack of n.
class LayerDraws {
  public:
    /// Collects the transparent draws of a selection, as `filter`, which may be null, has left them.
    void collect(const GpuScene::State& scene, const DrawSelection& draws, const TriangleFilter* filter);
    /// Lists the draws of each of `layers` layers. `find` marks them (`GeometryPass::findLayers`), from the
    /// number `firstNumber` on. Where that would take longer than it saves, there are no lists.
    void sort(std::uint32_t layers, const std::function<void()>& find);
    std::uint32_t firstNumber() const { return firstNumber_; }
    /// The draws of a layer; none where there are no lists.
    std::optional<DrawRuns> runs(std::uint32_t layer) const;

  private:
    /// A draw of one instance, or a part of one.
    struct Draw {
        std::size_t run;  ///< Index into `sources_`.
        DrawCommand command;
        std::uint32_t number;  ///< Among all of the scene.
    };
    void add(const GpuScene::State& scene, const TriangleFilter::Run& source,
             std::span<const DrawCommand> commands);
    std::vector<std::uint64_t> findLayers(const std::function<void()>& find);
    void list(std::uint64_t layerBit, std::span<const std::uint64_t> layersOf);

    std::vector<TriangleFilter::Run> sources_;
    std::vector<Draw> draws_;
    std::uint32_t firstNumber_ = 0, endNumber_ = 0;
    gl::Buffer layersOfDraws_{"layers of draws", gl::BufferUsage::readback};
    // The lists: those of layer i are the runs from `firstRun_[i]` on.
    std::vector<DrawCommand> commands_;
    std::vector<TriangleFilter::Run> runs_;
    std::vector<std::size_t> firstRun_;  ///< And the end of the last one. Empty without lists.
    gl::Buffer commandBuffer_{"draw commands of layers", gl::BufferUsage::dynamic};
};

}  // namespace candela
