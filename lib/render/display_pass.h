#pragma once

#include "gl/program.h"
#include "gl/texture.h"

#include <candela/color.h>
#include <candela/renderer.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace candela {

/// Shows a radiance texture through a display transform, with exposure before it and half a code value of
/// dither after it.
class DisplayPass {
  public:
    DisplayPass();
    ~DisplayPass();

    struct Inputs {
        const gl::Texture& radiance;
        int width, height;
        const DisplayTransform& transform;
        FrameTarget target;
    };
    void render(const Inputs& inputs);

  private:
    struct Prepared;
    const Prepared& prepare(const DisplayTransform& transform);

    gl::VertexArray vertexArray_;
    std::vector<std::unique_ptr<Prepared>>
        prepared_;  ///< One a transform that was shown; the text of its shader tells them apart.
};

}  // namespace candela
