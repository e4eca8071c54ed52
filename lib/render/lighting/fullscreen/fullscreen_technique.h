#pragma once

#include "gl/buffer.h"
#include "render/lighting/lighting_technique.h"

namespace candela {

/// Draws spans of lights over the whole picture with additive blending.
class FullscreenPass {
  public:
    explicit FullscreenPass(LightsPerInvocation limit = {});

    /// Adds all directional lights: what every technique does with them.
    void addDirectionals(const LightingInputs& inputs) const;
    /// Adds all point and spot lights.
    void addLocals(const LightingInputs& inputs) const;

  private:
    struct Span {
        int first = 0, end = 0;
    };
    void draw(const LightingInputs& inputs, Span points, Span spots, Span directionals) const;

    ModelPrograms programs_;
    LightsPerInvocation limit_;
    gl::VertexArray vertexArray_;
};

/// Every light at every pixel: the reference.
class FullscreenTechnique final : public LightingTechnique {
  public:
    explicit FullscreenTechnique(const FullscreenPass& pass) : pass_(pass) {}

    void render(const LightingInputs& inputs, gl::PassTimer& timer) override;
    std::uint64_t lightListBytes() const override { return 0; }
    std::uint64_t countEvaluated(const LightingInputs& inputs, PairCounter& counter) override;

  private:
    const FullscreenPass& pass_;
};

}  // namespace candela
