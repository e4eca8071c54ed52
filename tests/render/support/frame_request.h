#pragma once

#include <candela/renderer.h>

#include <cstdint>

namespace candela::test {

/// The view and the settings of a frame.
struct FrameRequest {
    int width = 0, height = 0;
    CameraView view;
    BrdfModel brdf = BrdfModel::course;
    Technique technique = Technique::automatic;
    DebugView debugView = DebugView::none;
    Overlays overlays = {};
    TileBackend tileBackend = TileBackend::automatic;
    Shadows shadows = Shadows::off;
    AmbientOcclusionSettings ambientOcclusion = {};
    bool specularAntialiasing = true;
    std::uint32_t layers = FrameSettings{}.layers;
    EnvironmentOcclusionSettings environmentOcclusion = {};

    FrameSettings settings() const {
        FrameSettings settings{width,    height,      brdf,    technique,       debugView,
                               overlays, tileBackend, shadows, ambientOcclusion};
        settings.specularAntialiasing = specularAntialiasing;
        settings.layers = layers;
        settings.environmentOcclusion = environmentOcclusion;
        return settings;
    }
};

inline Frame render(Renderer& renderer, GpuScene& scene, const FrameRequest& request) {
    return renderer.render(scene, request.view, request.settings());
}

}  // namespace candela::test
