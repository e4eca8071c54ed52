#pragma once

#include "render/lighting/fullscreen/fullscreen_technique.h"
#include "render/lighting/lighting_technique.h"
#include "render/lighting/pair_counter.h"

#include <candela/context.h>
#include <candela/renderer.h>

#include <map>
#include <memory>
#include <string>

namespace candela {

/// The lighting techniques of a renderer, each made when it is first asked for.
class Lighting {
  public:
    explicit Lighting(const Context& context);

    /// `technique` is not `automatic`.
    LightingTechnique& technique(Technique technique);
    PairCounter& counter();

    /// Binds what all techniques read.
    void bind(const LightingInputs& inputs) const;

  private:
    std::unique_ptr<LightingTechnique> make(Technique technique) const;

    std::string renderer_;
    gl::Texture albedo_;
    FullscreenPass fullscreen_;
    std::map<Technique, std::unique_ptr<LightingTechnique>> techniques_;
    std::unique_ptr<PairCounter> counter_;
};

}  // namespace candela
