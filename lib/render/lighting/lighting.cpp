#include "render/lighting/lighting.h"

#include "render/layout.h"
#include "render/lighting/tiled/compute_tiles.h"
#include "render/lighting/volumes/light_volumes.h"
#include "render/occlusion/occlusion_scene.h"

namespace candela {

Lighting::Lighting(const Context& context)
    : deviceBackend_(context.isSoftware() ? TileBackend::cpu : TileBackend::compute),
      limit_(context.isSoftware() ? LightsPerInvocation{} : LightsPerInvocation::onGpu()),
      fullscreen_(limit_) {}

std::unique_ptr<LightingTechnique> Lighting::create(Technique technique, TileBackend backend) const {
    if (technique == Technique::fullscreen) return std::make_unique<FullscreenTechnique>(fullscreen_);
    if (technique == Technique::volumes) return std::make_unique<VolumesTechnique>(fullscreen_);
    if (backend == TileBackend::cpu) return std::make_unique<CpuTiles>();
    return std::make_unique<ComputeTiles>(ComputeTiles::defaultListBytes, limit_);
}

TileBackend Lighting::tileBackend(TileBackend backend) const {
    return backend == TileBackend::automatic ? deviceBackend_ : backend;
}

LightingTechnique& Lighting::technique(Technique technique, TileBackend backend) {
    const TileBackend used = tileBackend(technique == Technique::tiles ? backend : TileBackend::automatic);
    auto& entry = techniques_[{technique, used}];
    if (!entry) entry = create(technique, used);
    return *entry;
}

CpuTiles& Lighting::cpuTiles() {
    return static_cast<CpuTiles&>(technique(Technique::tiles, TileBackend::cpu));
}

CpuTiles& Lighting::otherCpuTiles() {
    if (!otherTiles_) otherTiles_ = std::make_unique<CpuTiles>();
    return *otherTiles_;
}

bool Lighting::shadesInShaders(Technique technique, TileBackend backend) const {
    return technique != Technique::tiles || tileBackend(backend) != TileBackend::cpu;
}

PairCounter& Lighting::counter() {
    if (!counter_) counter_ = std::make_unique<PairCounter>();
    return *counter_;
}

std::vector<float> Lighting::shadowedPerPixel(const LightingInputs& inputs) {
    if (inputs.occlusion == nullptr) {
        return std::vector<float>(static_cast<std::size_t>(inputs.targets.width) *
                                  static_cast<std::size_t>(inputs.targets.height));
    }
    if (!shadowTiles_) shadowTiles_ = std::make_unique<CpuTiles>();
    return shadowTiles_->shadowedPerPixel(inputs);
}

void Lighting::bind(const LightingInputs& inputs) {
    std::optional<gl::Texture>& albedo = albedo_[static_cast<std::size_t>(inputs.brdf)];
    if (!albedo) albedo = makeAlbedoTexture(inputs.brdf);
    bindForLighting(inputs.targets, inputs.lights, *albedo);
    if (inputs.targets.parts.lobes) {
        if (!sheen_) sheen_ = makeSheenTexture();
        glBindTextureUnit(layout::SHEEN_UNIT, sheen_->name());
    }
    if (inputs.occlusion != nullptr && inputs.occlusion->shaderForm() != nullptr)
        inputs.occlusion->shaderForm()->bind();
}

const char* toString(Technique technique) {
    switch (technique) {
        case Technique::volumes:
            return "volumes";
        case Technique::tiles:
            return "tiles";
        case Technique::fullscreen:
            return "fullscreen";
        default:
            return "auto";
    }
}

const char* toString(TileBackend backend) {
    switch (backend) {
        case TileBackend::cpu:
            return "cpu";
        case TileBackend::compute:
            return "compute";
        default:
            return "auto";
    }
}

const char* toString(Shadows shadows) {
    switch (shadows) {
        case Shadows::off:
            return "off";
        case Shadows::on:
            return "on";
        default:
            return "auto";
    }
}

bool hasShadows() {
#ifdef CANDELA_SHADOWS
    return true;
#else
    return false;
#endif
}

}  // namespace candela
