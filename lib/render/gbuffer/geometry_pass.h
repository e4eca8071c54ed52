#pragma once

#include "gl/program.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/gpu_scene_state.h"

namespace candela {

/// Draws the surfaces in view into the G-buffer and their emission into the radiance target.
class GeometryPass {
  public:
    GeometryPass();

    struct Inputs {
        const GpuScene::State& scene;
        const DrawSelection& draws;  ///< Of the view.
        const GBufferTargets& targets;
        LoadOp radianceLoad;  ///< Where a draw emits, the target is cleared in any case.
    };
    void render(const Inputs& inputs) const;

  private:
    void draw(const DrawBatch& batch) const;

    gl::Program plain_, textured_;
};

}  // namespace candela
