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
    /// Whether a transform's curves may be baked into tables; see docs/color.md.
    enum class Baking {
        never,        ///< The exact shader, on GPUs.
        whereFaster,  ///< The faster of the two, found by timing both on a transform's first use.
        always,       ///< Wherever the transform can be baked: for tests.
    };
    explicit DisplayPass(Baking baking = Baking::never);
    ~DisplayPass();

    struct Inputs {
        const gl::Texture& radiance;
        int width, height;
        const DisplayTransform& transform;
        FrameTarget target;
    };
    void render(const Inputs& inputs);
    /// Whether `transform`, which was shown before, is shown through its baked form.
    bool isBaked(const DisplayTransform& transform) const;

  private:
    struct DisplayProgram;
    struct Prepared;
    Prepared* find(const DisplayTransform& transform) const;
    Prepared& prepare(const Inputs& inputs);
    void bake(Prepared& prepared, const Inputs& inputs);
    bool isWorthIt(const DisplayProgram& exact, const DisplayProgram& baked, const Inputs& inputs) const;
    void draw(const DisplayProgram& program, const Inputs& inputs) const;

    Baking baking_;
    gl::VertexArray vertexArray_;
    std::vector<std::unique_ptr<Prepared>>
        prepared_;  ///< One a transform that was shown; the text of its exact shader tells them apart.
};

}  // namespace candela
