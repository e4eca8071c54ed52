#pragma once

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/gpu_scene_state.h"

#include <candela/frame_settings.h>

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace candela {

/// Draws lines over a frame, one pixel wide, where its surfaces do not occlude them. They have a target of
/// their own, so that a frame can be displayed after its scene has been destroyed.
class OverlayPass {
  public:
    OverlayPass();

    struct Inputs {
        GpuScene::State& scene;
        const DrawSelection& draws;  ///< Of the view; the frame's uniform block is bound.
        const GBufferTargets& targets;
        Overlays overlays;
    };
    void render(const Inputs& inputs);
    /// Draws the lines of the last `render` over the host's framebuffer.
    void display(const FrameTarget& target) const;

  private:
    struct Target {
        Target(int width, int height);
        int width, height;
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    void begin(const GBufferTargets& targets);
    void drawMeshEdges(const Inputs& inputs) const;
    void drawCageLines(const Inputs& inputs, CageLineKind kind, const glm::vec3& color);

    gl::Program meshEdges_, cageLines_, display_;
    gl::VertexArray vertexArray_;
    std::optional<Target> target_;
    std::vector<CageLines> drawnLines_;
};

}  // namespace candela
