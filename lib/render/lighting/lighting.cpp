#include "render/lighting/lighting.h"

#include "render/lighting/lighting_bindings.h"
#include "render/lighting/tiled/tiles_choice.h"
#include "render/lighting/volumes/volumes_technique.h"

namespace candela {

Lighting::Lighting(const Context& context) : renderer_(context.renderer()), albedo_(makeAlbedoTexture()) {}

std::unique_ptr<LightingTechnique> Lighting::make(Technique technique) const {
    switch (technique) {
        case Technique::fullscreen:
            return std::make_unique<FullscreenTechnique>(fullscreen_);
        case Technique::volumes:
            return std::make_unique<VolumesTechnique>(fullscreen_);
        default:
            return makeFasterTiles(renderer_);
    }
}

LightingTechnique& Lighting::technique(Technique technique) {
    auto& made = techniques_[technique];
    if (!made) made = make(technique);
    return *made;
}

PairCounter& Lighting::counter() {
    if (!counter_) counter_ = std::make_unique<PairCounter>();
    return *counter_;
}

void Lighting::bind(const LightingInputs& inputs) const {
    bindForLighting(inputs.targets, inputs.lights, albedo_);
}

}  // namespace candela
