#pragma once

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/gpu_scene_state.h"

#include <candela/renderer.h>

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace candela {

/// Draws lines that lie over a frame, one pixel wide, where its surfaces do not hide them. They are kept in a
/// picture of their own: a host may show the frame when the scene has gone.
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
    /// Lays the lines that were drawn last over the host's framebuffer.
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
