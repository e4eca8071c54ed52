#pragma once

#include "gl/framebuffer.h"
#include "gl/pass_timer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/draw_list.h"

#include <candela/brdf.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// The layers of transparent surfaces of a frame: the G-buffers that they are drawn into, and what is kept of
/// each until it is composited (docs/layers.md). Everything outside of the rectangle of the frame is left
/// alone.
class LayerPass {
  public:
    LayerPass();

    /// Starts a frame whose layers lie in `rectangle`. `parts` are those of their G-buffer, `model` that of
    /// the frame.
    void begin(int width, int height, const GBufferParts& parts, const gl::PixelRectangle& rectangle,
               BrdfModel model);
    /// What layer `index`, 0 is the nearest, is drawn into. It replaces layer `index` - 2.
    const GBufferTargets& targets(std::uint32_t index) const { return *targets_[index % 2]; }
    /// Keeps the radiance and the coverage of layer `index`, which has been lit, and what is seen through it.
    /// Its textures are bound as for lighting. Returns the number of its pixels.
    std::uint64_t keep(std::uint32_t index);
    /// Lays the first `count` layers over the radiance of `frame`, the farthest first. Its alpha becomes
    /// their coverage. The frame's uniform block is bound.
    void composite(std::uint32_t count, const GBufferTargets& frame, Backdrop backdrop);

    /// How many fragments pass while `draw` runs.
    std::uint64_t countFragments(const std::function<void()>& draw) const;

  private:
    /// What is kept of a layer.
    struct Layer {
        Layer(int width, int height, const GBufferParts& parts);
        gl::Texture color;        ///< RGBA32F: radiance, coverage.
        gl::Texture seenThrough;  ///< RGBA32UI, see shaders/layer_store.frag; of layers with refraction.
        gl::Framebuffer framebuffer;
    };
    bool refracts() const { return targets_[0]->parts.refraction; }
    const gl::Program& programOf(const char* file, Backdrop backdrop);
    void copyBackdrop(const gl::Texture& radiance, Backdrop backdrop);
    void drawTriangle(const gl::Program& program, const gl::Framebuffer& into) const;

    std::map<std::string, gl::Program> programs_;  ///< By file and definitions.
    gl::VertexArray vertexArray_;
    gl::Object<gl::deleteQuery> query_;
    gl::PixelRectangle rectangle_;
    BrdfModel model_ = BrdfModel::course;
    std::array<std::optional<GBufferTargets>, 2> targets_;
    std::vector<Layer> layers_;  ///< As many as a frame of this size has needed.
    std::optional<gl::Texture> backdrop_;
};

}  // namespace candela
