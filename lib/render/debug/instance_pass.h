#pragma once

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/gpu_scene/gpu_scene_state.h"

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>

namespace candela {

/// Draws the instance at each pixel of a frame, with the same draws as the geometry pass.
class InstancePass {
  public:
    struct Inputs {
        const GpuScene::State& scene;
        const DrawSelection& draws;  ///< Of the view; the frame's uniform block is bound.
        int width, height;
    };
    /// R32UI: the instance at each pixel, counted from 1; 0 on the background.
    const gl::Texture& render(const Inputs& inputs);
    /// The instance at one pixel, y from the bottom; none on the background. Draws that pixel alone.
    std::optional<std::uint32_t> at(const Inputs& inputs, int x, int y);

  private:
    struct Targets {
        Targets(int width, int height);
        int width, height;
        gl::Texture instances, depth;
        gl::Framebuffer framebuffer;
    };
    struct Programs {
        gl::Program plain, textured;
        /// Of lines and points, and of materials that read further sets of texture coordinates.
        std::map<std::tuple<Topology, PipelineKey::Program, std::uint32_t>, gl::Program> special;

        const gl::Program& of(const PipelineKey& key);
    };
    void prepare(int width, int height);
    void drawBatches(const Inputs& inputs);
    void draw(const GpuScene::State& scene, const DrawBatch& batch);

    // Created when they are first needed.
    std::optional<Programs> programs_;
    std::optional<Targets> targets_;
};

}  // namespace candela
