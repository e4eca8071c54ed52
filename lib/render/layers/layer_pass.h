#pragma once

#include "gl/framebuffer.h"
#include "gl/pass_timer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/draw_list.h"

#include <candela/brdf.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// The layers of transparent surfaces of a frame: the G-buffers that they are drawn into, and what is kept of
/// each until it is composited (docs/layers.md). Everything outside of a layer's rectangle is left alone.
class LayerPass {
  public:
    LayerPass();

    /// Starts a frame. `parts` are those of the layers' G-buffer, `model` that of the frame.
    void begin(int width, int height, const GBufferParts& parts, BrdfModel model);
    /// The targets that a layer is drawn into, cleared. There is one set for all.
    const GBufferTargets& clear(const gl::PixelRectangle& rectangle);
    /// Keeps the radiance and the coverage of layer `index`, 0 is the nearest, which has been lit, and what
    /// is seen through it. Its textures are bound as for lighting.
    void keep(std::uint32_t index, const gl::PixelRectangle& rectangle);
    /// Adds to a picture, of associated alpha, what lies behind all surfaces and is not part of the picture.
    using DrawBehind = std::function<void(const gl::Framebuffer& picture)>;
    /// Lays the first `count` layers over the radiance of `frame`, the farthest first. Its alpha becomes
    /// their coverage. What transmits shows what `drawBehind`, which may be empty, draws as well. The frame's
    /// uniform block is bound.
    void composite(std::uint32_t count, const GBufferTargets& frame, Backdrop backdrop,
                   const DrawBehind& drawBehind);

  private:
    /// What is kept of a layer.
    struct Layer {
        Layer(int width, int height, const GBufferParts& parts);
        gl::Texture color;        ///< RGBA32F: radiance, coverage.
        gl::Texture seenThrough;  ///< RGBA32UI, see shaders/layer_store.frag; of layers with refraction.
        gl::Framebuffer framebuffer;
        gl::PixelRectangle rectangle;  ///< Of the last frame that had the layer.
    };
    bool refracts() const { return targets_->parts.refraction; }
    const gl::Program& programOf(const char* file, Backdrop backdrop);
    /// What the next layer is seen in front of: of `part`, all else is as it was.
    void copyBackdrop(const GBufferTargets& frame, const gl::PixelRectangle& part, Backdrop backdrop,
                      const DrawBehind& drawBehind);
    void drawTriangle(const gl::Program& program, const gl::Framebuffer& into) const;

    std::map<std::string, gl::Program> programs_;  ///< By file and definitions.
    gl::VertexArray vertexArray_;
    BrdfModel model_ = BrdfModel::course;
    std::optional<GBufferTargets> targets_;
    gl::PixelRectangle written_;           ///< What of them is not clear.
    std::vector<Layer> layers_;            ///< As many as a frame of this size has needed.
    std::optional<gl::Texture> backdrop_;  ///< RGBA32F, with levels.
};

}  // namespace candela
