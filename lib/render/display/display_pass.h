#pragma once

#include "gl/program.h"
#include "gl/texture.h"

#include <candela/color.h>
#include <candela/frame_settings.h>

#include <glm/vec2.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace candela {

/// Draws a radiance texture through a display transform, with exposure before it and half a code value of
/// dither after it.
class DisplayPass {
  public:
    /// Whether a transform's curves are baked into tables; see docs/color.md.
    enum class Baking {
        never,   ///< The exact shader: for GPUs.
        always,  ///< Tables wherever a transform has curves that gain by it: for software rasterisers.
    };
    explicit DisplayPass(Baking baking = Baking::never);
    ~DisplayPass();

    struct Inputs {
        const gl::Texture& radiance;
        int width, height;
        const DisplayTransform& transform;
        FrameTarget target;
        /// The lower left pixel in the picture of which this is a part: dither is that of the whole.
        glm::ivec2 place{0, 0};
    };
    void render(const Inputs& inputs);
    /// Whether `transform`, which `render` was given before, is drawn through its baked shader.
    bool isBaked(const DisplayTransform& transform) const;
    std::size_t programCount() const { return prepared_.size(); }

  private:
    struct DisplayProgram;
    struct Prepared;
    const Prepared* find(const DisplayTransform& transform) const;
    const Prepared& prepare(const DisplayTransform& transform);

    Baking baking_;
    gl::VertexArray vertexArray_;
    std::vector<std::unique_ptr<Prepared>> prepared_;
};

}  // namespace candela
