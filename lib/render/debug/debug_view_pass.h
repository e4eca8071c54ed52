#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "render/debug/instance_pass.h"
#include "render/debug/max_reduction.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "render/lighting/lighting.h"

#include <candela/renderer.h>

#include <cstdint>
#include <map>

namespace candela {

/// Draws a data view: code values of the display instead of light.
class DebugViewPass {
  public:
    DebugViewPass();

    struct Inputs {
        DebugView debugView;  ///< Not `none`.
        const GpuScene::State& scene;
        const DrawSelection& draws;
        const LightingInputs& frame;  ///< Bound as for lighting.
        Lighting& lighting;           ///< Counts the lights.
        InstancePass& instances;
    };
    /// Writes the view's code values into the radiance target, which holds emission where
    /// `DebugView::emission` is asked for. The frame's uniform block is bound.
    void render(const Inputs& inputs);
    /// The end of the heat map in the last view of light counts.
    std::uint32_t maxLightCount() const;

    /// Brings the code values to the host's framebuffer as they are.
    void display(const GBufferTargets& targets, const FrameTarget& target) const;

  private:
    void prepare(const Inputs& inputs);
    void prepareLevels(const Inputs& inputs);
    const gl::Program& program(DebugView debugView);

    std::map<DebugView, gl::Program> programs_;
    gl::Program display_;
    gl::VertexArray vertexArray_;
    MaxReduction maxReduction_;
    gl::BufferTexture instanceColors_;
};

}  // namespace candela
