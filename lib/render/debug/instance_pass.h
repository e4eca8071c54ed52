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
    /// Whether a pass also draws where the points of surfaces were, of which `PreviousVertices` are bound.
    enum class Motion { off, on };
    /// RG32UI, `SurfaceId` of each pixel.
    const gl::Texture& render(const Inputs& inputs);
    /// Those of a rectangle, rows from the bottom. Draws it alone.
    std::vector<SurfaceId> read(const Inputs& inputs, const gl::PixelRectangle& rectangle);
    /// Where the point of the surface of each pixel was, rows from the bottom: three numbers in the frame of
    /// its instance, and 1; and 0 where the vertices of the instance rest. `PreviousVertices` are bound.
    std::vector<float> readPreviousPositions(const Inputs& inputs);

  private:
    struct Targets {
        Targets(int width, int height, Motion motion);
        int width, height;
        gl::Texture instances, depth, previous;
        gl::Framebuffer framebuffer;
    };
    const gl::Program& programOf(const PipelineKey& key, Motion motion);
    Targets& prepare(int width, int height, Motion motion);
    void drawBatches(const Inputs& inputs, Motion motion);
    void draw(const GpuScene::State& scene, const DrawBatch& batch, Motion motion);

    // Created when they are first needed.
    std::map<std::tuple<Topology, bool, std::uint32_t, Motion>, gl::Program> programs_;
    std::map<Motion, Targets> targets_;
};

}  // namespace candela
