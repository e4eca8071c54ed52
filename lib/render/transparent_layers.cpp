#include "render/environment/gpu_environment.h"
#include "render/lighting/tiled/tile_kernel.h"
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

/// The tiles that a rectangle touches with four pixels around it, which the filter of occlusion rays reads.
gl::PixelRectangle tilesAround(const gl::PixelRectangle& rectangle, int width, int height) {
    constexpr int filter = 4;
    const auto low = [](int first) { return std::max(first - filter, 0) / tileSize * tileSize; };
    const auto high = [](int end, int size) {
        return std::min((end + filter + tileSize - 1) / tileSize * tileSize, size);
    };
    const int left = low(rectangle.x), bottom = low(rectangle.y);
    return {left, bottom, high(rectangle.x + rectangle.width, width) - left,
            high(rectangle.y + rectangle.height, height) - bottom};
}

}  // namespace

void Renderer::State::drawLayers(const GpuScene::State& scene) {
    const gl::PassTimer::Scope pass(timer, "layers");
    const gl::PixelRectangle rectangle =
        transparentRectangle(scene, draws, frame->frustum, {targets->width, targets->height});
    if (!layers) layers.emplace();
    if (!fragmentLists) fragmentLists.emplace();
    if (!layerDraws) layerDraws.emplace();
    GBufferParts parts = targets->parts;
    parts.layer = true;
    parts.refraction = draws.backdrop() != Backdrop::none;
    layers->begin(targets->width, targets->height, parts, frame->settings.brdf);
    const GeometryPass::Inputs all{
        scene, draws, *targets, LoadOp::load, SurfaceSet::transparent, scene.triangleFilter.get()};
    const LayerExtents extents =
        fragmentLists->record(targets->width, targets->height, rectangle, frame->settings.layers,
                              [&] { geometry.recordFragments(all); });
    layerDraws->collect(scene, draws, scene.triangleFilter.get());
    layerDraws->sort(static_cast<std::uint32_t>(extents.layers.size()), [&] {
        fragmentLists->bind();
        const gl::Scissor within(rectangle);
        geometry.findLayers(all, layerDraws->firstNumber());
    });
    std::uint32_t count = 0;
    for (const LayerExtents::Layer& layer : extents.layers) drawLayer(scene, count++, layer);
    layerCounts = {count, extents.fragmentsBeyond};
}

void Renderer::State::drawLayer(const GpuScene::State& scene, std::uint32_t index,
                                const LayerExtents::Layer& layer) {
    const GBufferTargets& into = layers->clear(layer.rectangle);
    fragmentLists->drawDepth(index, into, layer.rectangle);
    const std::optional<DrawRuns> runs = layerDraws->runs(index);
    const GeometryPass::Inputs inputs{
        scene,
        draws,
        into,
        lighting.technique(frame->technique, frame->settings.tileBackend).radianceLoadOp(),
        SurfaceSet::transparent,
        scene.triangleFilter.get(),
        runs ? &*runs : nullptr};
    {
        const gl::Scissor within(layer.rectangle);
        if (layer.sharesDepths)
            fragmentLists->number(index, layer.rectangle, [&] { geometry.numberSurfaces(inputs, index); });
        geometry.renderLayer(inputs, layer.sharesDepths ? DepthTies::numbered : DepthTies::none);
        layerSurfaces.reset(into, tilesAround(layer.rectangle, into.width, into.height));
        layerSurfaces.emits = draws.emits(SurfaceSet::transparent);
        layerTimer.beginFrame();
        light(scene, layerSurfaces, layerTimer);
    }
    lighting.bind(lightingInputs(scene, layerSurfaces));
    layers->keep(index, layer.rectangle);
}

void Renderer::State::compositeLayers(const GpuScene::State& scene) {
    const gl::PassTimer::Scope pass(timer, "composite");
    LayerPass::DrawBehind drawBehind;
    if (scene.environment && scene.environment->lights() && !scene.environment->isBackground()) {
        drawBehind = [&](const gl::Framebuffer& picture) {
            environment.drawBehind(picture, *targets, *scene.environment);
        };
    }
    layers->composite(layerCounts.layers, *targets, draws.backdrop(), drawBehind);
}

}  // namespace candela
