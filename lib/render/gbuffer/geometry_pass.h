#pragma once

#include "gl/program.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/gpu_scene_state.h"

namespace candela {

/// Draws the surfaces in view into the G-buffer and their emission into the radiance target.
class GeometryPass {
  public:
    GeometryPass();

    /// What the radiance target holds after the pass where nothing emits.
    enum class LoadOp {
        clear,     ///< Black.
        dontCare,  ///< When nothing in view emits, the target is left as it is.
    };
    struct Inputs {
        const GpuScene::State& scene;
        const DrawSelection& draws;  ///< Of the view.
        const GBufferTargets& targets;
        LoadOp radianceLoad;
    };
    void render(const Inputs& inputs) const;

  private:
    void draw(const DrawBatch& batch) const;

    gl::Program plain_, textured_;
};

}  // namespace candela
