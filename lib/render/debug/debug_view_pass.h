#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/debug/instance_pass.h"
#include "render/gbuffer/channels.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/gpu_scene_state.h"
#include "render/lighting/lighting.h"

#include <candela/frame_settings.h>

#include <glm/vec2.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace candela {

/// The largest value of a texture, found on the device.
class MaxReduction {
  public:
    MaxReduction();

    /// Reduces the first components of `texture`, which has the frame's size and no value below 0, and leaves
    /// the result bound for shaders/lib/max_reduction.glsl.
    void reduce(const gl::Texture& texture, int width, int height);
    /// What `reduce` found last. Waits for it.
    float value() const;

  private:
    gl::Program program_;
    gl::Buffer buffer_;
};

/// The definitions with which shaders/debug_view.frag is compiled for a view.
std::vector<std::string> debugViewDefinitions(const DebugViewRow& row);

/// Draws a debug view: code values of the display instead of light. The views are rows of the channel table
/// (render/gbuffer/channels.h).
class DebugViewPass {
  public:
    DebugViewPass();

    struct Inputs {
        DebugView view;  ///< Not `none`.
        const GpuScene::State& scene;
        const DrawSelection& draws;
        const LightingInputs& frame;  ///< Bound as for lighting.
        Lighting& lighting;           ///< Counts the lights.
        InstancePass& instances;
        const std::function<void(GLuint framebuffer)>& drawHostDepth;  ///< As `InstancePass::Inputs` has it.
    };
    /// Writes the view's code values into the radiance target, which holds emission where
    /// `DebugView::emission` is asked for. The frame's uniform block is bound.
    void render(const Inputs& inputs);
    /// The end of the heat map in the last view of counts of lights.
    std::uint32_t maxLightCount() const;

    /// Copies the code values to the host's framebuffer as they are.
    void display(const GBufferTargets& targets, const FrameTarget& target) const;

  private:
    void copyEmission(const GBufferTargets& targets);
    void uploadShadowedCounts(const Inputs& inputs);
    const gl::Texture* drawSource(const Inputs& inputs, ChannelSource source);
    void uploadLevelColors(const GpuScene::State& scene);
    const gl::Program& program(DebugView view);
    void drawTriangle() const;

    std::map<DebugView, gl::Program> programs_;
    gl::Program display_;
    gl::VertexArray vertexArray_;
    MaxReduction maximum_;
    gl::Texture emission_;  ///< Created for the first view of emission.
    glm::ivec2 emissionSize_{0};
    gl::Texture shadowedCounts_;  ///< Of the last view of them.
    gl::BufferTexture instanceColors_;
};

}  // namespace candela
