#pragma once

#include "gl/program.h"
#include "gl/texture.h"

#include <candela/camera.h>
#include <candela/frame_settings.h>

#include <glm/vec4.hpp>

#include <optional>

namespace candela {

/// How the values of a depth buffer follow from distances along the view axis.
struct DepthScale {
    bool orthographic;
    DepthConvention::Direction direction;
    double nearPlane;
    std::optional<double> farPlane;  ///< None: at infinity. Orthographic ones have one.

    bool hasSamePlanes(const DepthScale& other) const {
        return nearPlane == other.nearPlane && farPlane == other.farPlane;
    }
    /// As depth_conversion.frag has it.
    glm::vec4 uniform() const;
};

/// That of the G-buffer. An orthographic view has a far plane.
DepthScale depthScale(const CameraView& view);
/// That of a host which draws from `view`. Throws `Error` (badInput) when its planes are out of their range.
DepthScale depthScale(const CameraView& view, const DepthConvention& convention);

/// Copies depth from a texture into the depth buffer of a framebuffer, from one scale to another. The far
/// plane, and what is beyond it, stays the far plane. Copies radiance by the same depth.
class DepthConversion {
  public:
    DepthConversion();

    struct Inputs {
        GLuint depth;  ///< A 2D texture, whose first channel is read; 0: the far plane everywhere.
        DepthScale from, to;
        FrameTarget target;
        int width, height;
    };
    void render(const Inputs& inputs);
    /// Copies `radiance` into colour buffer 0 where the target's depth is the one that `render` writes. The
    /// depth test is on, and stays so.
    void renderRadiance(GLuint radiance, const Inputs& inputs);

  private:
    void draw(const gl::Program& program, const Inputs& inputs);

    gl::Program depth_, depthAndRadiance_, radiance_;
    gl::Sampler sampler_;
    gl::VertexArray vertexArray_;
};

}  // namespace candela
