#pragma once

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/gpu_scene/gpu_scene_state.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace candela {

/// What a pixel shows, counted from 1; 0 on the background and of surfaces of a host.
struct SurfaceId {
    std::uint32_t instance = 0;
    std::uint32_t material = 0;  ///< Index into `Scene::materials`, or `DrawList::noMaterial`, and 1.
};

/// Draws the instance and the material at each pixel of a frame, with the same draws as the geometry pass.
class InstancePass {
  public:
    struct Inputs {
        const GpuScene::State& scene;
        const DrawSelection& draws;  ///< Of the view; the frame's uniform block is bound.
        int width, height;
        /// Draws the depth of a host's surfaces; empty: there are none.
        std::function<void(GLuint framebuffer)> drawHostDepth = {};
    };
    /// RG32UI, `SurfaceId` of each pixel.
    const gl::Texture& render(const Inputs& inputs);
    /// Those of a rectangle, rows from the bottom. Draws it alone.
    std::vector<SurfaceId> read(const Inputs& inputs, const gl::PixelRectangle& rectangle);

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
