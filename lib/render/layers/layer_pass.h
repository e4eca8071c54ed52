#pragma once

#include "gl/framebuffer.h"
#include "gl/pass_timer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/gbuffer/gbuffer_targets.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace candela {

/// The layers of transparent surfaces of a frame: the G-buffers that they are drawn into, and what is kept of
/// each until it is composited (docs/layers.md). Everything outside of the rectangle of the frame is left
/// alone.
class LayerPass {
  public:
    LayerPass();

    /// Starts a frame whose layers lie in `rectangle`. `parts` are those of their G-buffer.
    void begin(int width, int height, const GBufferParts& parts, const gl::PixelRectangle& rectangle);
    /// What layer `index`, 0 is the nearest, is drawn into. It replaces layer `index` - 2.
    const GBufferTargets& targets(std::uint32_t index) const { return *targets_[index % 2]; }
    /// Keeps the radiance and the coverage of layer `index`, which has been lit. Returns the number of its
    /// pixels.
    std::uint64_t keep(std::uint32_t index);
    /// Lays the first `count` layers over the radiance of `frame`, the farthest first. Its alpha becomes
    /// their coverage.
    void composite(std::uint32_t count, const GBufferTargets& frame) const;

    /// How many fragments pass while `draw` runs.
    std::uint64_t countFragments(const std::function<void()>& draw) const;

  private:
    /// What is kept of a layer.
    struct Layer {
        Layer(int width, int height);
        gl::Texture color;  ///< RGBA32F: radiance, coverage.
        gl::Framebuffer framebuffer;
    };
    void clearTargets() const;
    void drawTriangle(const gl::Program& program, const gl::Framebuffer& into) const;

    gl::Program store_, composite_;
    gl::VertexArray vertexArray_;
    gl::Object<gl::deleteQuery> query_;
    gl::PixelRectangle rectangle_;
    std::array<std::optional<GBufferTargets>, 2> targets_;
    std::vector<Layer> layers_;  ///< As many as a frame of this size has needed.
};

}  // namespace candela
