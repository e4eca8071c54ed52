#include "render/renderer_state.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// The pixels that the bounding spheres of the transparent instances in view touch, and one around them for
/// the rounding of the rasteriser.
gl::PixelRectangle transparentRectangle(const GpuScene::State& scene, const DrawSelection& draws,
                                        const Frustum& frustum, glm::vec2 size) {
    glm::vec2 low = size, high(0.0f);
    for (const std::uint32_t instance : draws.transparentInstances()) {
        const glm::vec3 center = scene.instances.sphere(instance).center;
        const float radius = scene.instances.drawnRadius(instance, frustum);
        Frustum::Rectangle bounds{{0.0f, 0.0f}, {1.0f, 1.0f}};
        if (!frustum.meetsNearPlane(center, radius)) bounds = frustum.projectedBounds(center, radius);
        low = glm::min(low, bounds.min * size - 1.0f);
        high = glm::max(high, bounds.max * size + 1.0f);
    }
    low = glm::floor(glm::clamp(low, glm::vec2(0.0f), size));
    high = glm::max(glm::ceil(glm::clamp(high, glm::vec2(0.0f), size)), low);
    return {static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(high.x - low.x),
            static_cast<int>(high.y - low.y)};
}

}  // namespace

void Renderer::State::drawLayers(const GpuScene::State& scene) {
    const gl::PassTimer::Scope pass(timer, "layers");
    const gl::PixelRectangle rectangle =
        transparentRectangle(scene, draws, frame->frustum, {targets->width, targets->height});
    GBufferParts parts = targets->parts;
    parts.layer = true;
    parts.refraction = draws.backdrop() != Backdrop::none;
    if (!layers) layers.emplace();
    layers->begin(targets->width, targets->height, parts, rectangle, frame->settings.brdf);
    const LoadOp radianceLoad =
        lighting.technique(frame->technique, frame->settings.tileBackend).radianceLoadOp();
    const auto inputsOf = [&](std::uint32_t layer, const LayerDepths& depths) {
        return GeometryPass::Inputs{scene,
                                    draws,
                                    layers->targets(layer),
                                    radianceLoad,
                                    SurfaceSet::transparent,
                                    &depths,
                                    scene.triangleFilter.get()};
    };
    const LayerDepths all{targets->depth, nullptr};
    const auto drawAll = [&] {
        const gl::Scissor within(rectangle);
        geometry.drawFragments(inputsOf(0, all));
    };
    if (drawsBeforeQueries) drawAll();
    std::uint64_t fragments = layers->countFragments(drawAll);
    std::uint32_t count = 0;
    while (fragments > 0 && count < frame->settings.layers) {
        const LayerDepths depths{targets->depth, count == 0 ? nullptr : &layers->targets(count - 1).depth};
        {
            const gl::Scissor within(rectangle);
            geometry.render(inputsOf(count, depths));
            layerSurfaces.reset(layers->targets(count));
            layerSurfaces.emits = draws.emits(SurfaceSet::transparent);
            layerTimer.beginFrame();
            light(scene, layerSurfaces, layerTimer);
        }
        lighting.bind(lightingInputs(scene, layerSurfaces));
        const std::uint64_t pixels = layers->keep(count);
        // Surfaces at the depth of another one are all that is left.
        if (pixels == 0) break;
        fragments -= pixels;
        ++count;
    }
    layerCounts = {count, fragments};
}

void Renderer::State::compositeLayers() {
    const gl::PassTimer::Scope pass(timer, "composite");
    layers->composite(layerCounts.layers, *targets, draws.backdrop());
}

}  // namespace candela
