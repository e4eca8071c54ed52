#include "gl/state_guard.h"
#include "render/debug/probe.h"
#include "render/display/display_target.h"
#include "render/gbuffer/readback.h"
#include "render/renderer_state.h"

#include <candela/error.h>

#include <numeric>
#include <string>

namespace candela {

namespace {

constexpr const char* user = "a Frame";

void checkPixel(const FrameSettings& settings, int x, int y) {
    if (x >= 0 && x < settings.width && y >= 0 && y < settings.height) return;
    throw Error(ErrorKind::badInput, "",
                "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is asked for of a picture of " +
                    std::to_string(settings.width) + "x" + std::to_string(settings.height) + " pixels");
}

}  // namespace

Frame::Frame(std::shared_ptr<Renderer::State> renderer, std::weak_ptr<GpuScene::State> scene,
             std::uint64_t number)
    : renderer_(std::move(renderer)), scene_(std::move(scene)), number_(number) {}
Frame::Frame(Frame&&) noexcept = default;
Frame& Frame::operator=(Frame&&) noexcept = default;
Frame::~Frame() = default;

Renderer::State& Frame::state() const {
    if (!renderer_) throw Error(ErrorKind::badInput, "", "a Frame is used that was moved from");
    if (renderer_->frameNumber != number_) {
        throw Error(ErrorKind::badInput, "",
                    "a Frame is used after its renderer has drawn another one, which replaced it");
    }
    return *renderer_;
}

std::shared_ptr<GpuScene::State> Frame::scene() const {
    if (auto scene = scene_.lock()) return scene;
    throw Error(ErrorKind::badInput, "",
                "a Frame is asked for what has to be drawn again, but its GpuScene has been destroyed");
}

int Frame::width() const {
    return state().frame->settings.width;
}

int Frame::height() const {
    return state().frame->settings.height;
}

Technique Frame::technique() const {
    return state().frame->technique;
}

std::optional<TileBackend> Frame::tileBackend() const {
    const Renderer::State& state = this->state();
    const DrawnFrame& frame = *state.frame;
    if (frame.technique != Technique::tiles || frame.settings.debugView != DebugView::none)
        return std::nullopt;
    return state.lighting.tileBackend(frame.settings.tileBackend);
}

void Frame::display(const DisplayTransform& transform, const FrameTarget& target) const {
    Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    requireTarget(target);
    state.displayFrame(transform, target);
}

std::vector<std::uint8_t> Frame::displayPicture(const DisplayTransform& transform) const {
    Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    return state.displayPicture(transform);
}

LayerCounts Frame::layerCounts() const {
    return state().layerCounts;
}

HdrImage Frame::radiance() const {
    const Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    const GBufferTargets& targets = *state.targets;
    return wholeRadiance(targets.width, targets.height,
                         readColor(targets.litRadiance(), targets.width, targets.height), readDepth(targets));
}

std::optional<PixelProbe> Frame::probe(int x, int y) const {
    Renderer::State& state = this->state();
    const DrawnFrame& frame = *state.frame;
    checkPixel(frame.settings, x, y);
    const gl::StateGuard guard(*state.binding, user);
    const std::shared_ptr<GpuScene::State> scene = this->scene();
    const int fromBottom = frame.settings.height - 1 - y;
    state.bindFrame();
    const ShadedSurfaces& shown = frame.hasTransparent ? state.drawMasked(*scene) : state.frameSurfaces;
    std::optional<PixelProbe> probe =
        probeSurface({*shown.targets, frame.uniforms, scene->lights, x, fromBottom});
    if (!probe) return std::nullopt;
    probe->radiance = readColorAt(state.targets->litRadiance(), x, fromBottom);
    const std::uint32_t instance = state.surfaceIds(*scene, {x, fromBottom, 1, 1})[0].instance;
    if (instance == 0) return std::nullopt;  // What the frame shows here has been hidden or moved since.
    probe->node = scene->instances[instance - 1].node;
    probe->emission = state.emissionAt(*scene, x, fromBottom);
    return probe;
}

std::uint32_t Frame::maxLightCount() const {
    const Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    const DebugView view = state.frame->settings.debugView;
    if (view != DebugView::lightCount && view != DebugView::shadowedCount) return 0;
    return state.debugView->maxLightCount();
}

PairCounts Frame::countPairs() const {
    Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    const std::shared_ptr<GpuScene::State> scene = this->scene();
    state.bindFrame();
    const LightingInputs inputs = state.lightingInputs(*scene, state.frameSurfaces);
    state.lighting.bind(inputs);
    PairCounter& counter = state.lighting.counter();
    const auto directionals = static_cast<std::uint64_t>(inputs.lights.counts().directionals);
    const std::uint64_t directionalPairs = directionals * countLitSurfaces(*state.targets);
    const std::vector<float> lit = counter.litPerPixel(inputs);
    PairCounts counts;
    counts.lightsVisible = counter.lightsInView(inputs) + directionals;
    counts.pairsLit =
        static_cast<std::uint64_t>(std::accumulate(lit.begin(), lit.end(), 0.0)) + directionalPairs;
    if (state.frame->settings.debugView != DebugView::none) return counts;  // No light was evaluated.
    LightingTechnique& technique =
        state.lighting.technique(state.frame->technique, state.frame->settings.tileBackend);
    counts.pairsEvaluated = technique.countEvaluated(inputs, counter) + directionalPairs;
    counts.lightListBytes = technique.lightListBytes();
    return counts;
}

ShadowCounts Frame::shadowCounts() const {
    Renderer::State& state = this->state();
    const DrawnFrame& frame = *state.frame;
    if (!frame.traced.shadows || !state.lighting.shadesInShaders(frame.technique, frame.settings.tileBackend))
        return state.shadowCounts;
    const gl::StateGuard guard(*state.binding, user);
    const std::shared_ptr<GpuScene::State> scene = this->scene();
    state.bindFrame();
    const LightingInputs inputs = state.lightingInputs(*scene, state.frameSurfaces);
    state.lighting.bind(inputs);
    const std::uint64_t rays = state.lighting.counter().countRays(inputs);
    return {.raysAsked = rays, .raysTraced = rays, .raysSaved = 0};
}

std::vector<PassTime> Frame::passTimes() const {
    Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    if (!state.samplePasses.empty()) return state.samplePasses;
    std::vector<PassTime> times;
    for (const auto& [name, milliseconds] : state.timer.results()) times.push_back({name, milliseconds});
    return times;
}

}  // namespace candela
