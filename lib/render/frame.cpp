#include "gl/state_guard.h"
#include "render/debug/aovs.h"
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
    HdrImage image{targets.width, targets.height,
                   readColor(targets.litRadiance(), targets.width, targets.height)};
    const std::vector<float> depth = readDepth(targets);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (depth[i] > 0.0f) image.rgba[4 * i + 3] = 1.0f;
    }
    flipRows(image.rgba, targets.width, targets.height);
    return image;
}

std::vector<std::string> Renderer::aovNames() {
    std::vector<std::string> names;
    for (const ChannelRow& row : channelRows()) {
        if (row.source != ChannelSource::ambientOcclusion || hasShadows())
            names.emplace_back(row.channel.name);
    }
    return names;
}

std::vector<Aov> Frame::aovs(const std::vector<std::string>& names) const {
    const std::vector<const ChannelRow*> rows = findAovs(names);
    Renderer::State& state = this->state();
    const gl::StateGuard guard(*state.binding, user);
    state.bindFrame();
    ShadedSurfaces& shown = state.frame->hasTransparent ? state.drawMasked(*scene()) : state.frameSurfaces;
    const GBufferTargets& targets = *shown.targets;
    std::vector<float> emission, lightCount, shadowedCount, ambientOcclusion;
    if (usesSource(rows, ChannelSource::emission)) {
        emission = readColor(state.drawEmission(*scene()).radiance, targets.width, targets.height);
    }
    const auto environmentOf = [&](ChannelSource source, EnvironmentPass::Parts parts) {
        if (!usesSource(rows, source)) return std::vector<float>{};
        return readColor(state.drawEnvironment(*scene(), shown, parts).radiance, targets.width,
                         targets.height);
    };
    const std::vector<float> environment = environmentOf(ChannelSource::environment, {});
    const std::vector<float> environmentDiffuse =
        environmentOf(ChannelSource::environmentDiffuse, {.diffuse = 1.0f, .specular = 0.0f});
    const std::vector<float> environmentSpecular =
        environmentOf(ChannelSource::environmentSpecular, {.diffuse = 0.0f, .specular = 1.0f});
    if (usesSource(rows, ChannelSource::lightCount)) {
        const std::shared_ptr<GpuScene::State> scene = this->scene();
        const LightingInputs inputs = state.lightingInputs(*scene, shown);
        state.lighting.bind(inputs);
        lightCount = state.lighting.counter().litPerPixel(inputs);
    }
    if (usesSource(rows, ChannelSource::shadowedCount))
        shadowedCount = state.countShadowed(*scene(), targets);
    if (usesSource(rows, ChannelSource::ambientOcclusion))
        ambientOcclusion = state.traceAmbientOcclusion(*scene(), targets);
    const std::vector<GBufferTexel> surfaces = readSurfaces(targets);
    const std::vector<float> depth = readDepth(targets);
    const AovSources sources{
        targets.width, targets.height, state.frame->uniforms, state.frame->origin, depth,
        surfaces,      emission,       environment,           environmentDiffuse,  environmentSpecular,
        lightCount,    shadowedCount,  ambientOcclusion};
    std::vector<Aov> result;
    for (const ChannelRow* row : rows) result.push_back(makeAov(*row, sources));
    return result;
}

std::optional<PixelProbe> Frame::probe(int x, int y) const {
    Renderer::State& state = this->state();
    const DrawnFrame& frame = *state.frame;
    checkPixel(frame.settings, x, y);
    const gl::StateGuard guard(*state.binding, user);
    const std::shared_ptr<GpuScene::State> scene = this->scene();
    const int width = frame.settings.width, height = frame.settings.height, fromBottom = height - 1 - y;
    state.bindFrame();
    const ShadedSurfaces& shown = frame.hasTransparent ? state.drawMasked(*scene) : state.frameSurfaces;
    std::optional<PixelProbe> probe =
        probeSurface({*shown.targets, frame.uniforms, scene->lights, x, fromBottom});
    if (!probe) return std::nullopt;
    probe->radiance = readColorAt(state.targets->litRadiance(), x, fromBottom);
    scene->cull(frame.frustum, state.draws);
    const std::optional<std::uint32_t> instance =
        state.instances.at({*scene, state.draws, width, height}, x, fromBottom);
    if (!instance) return std::nullopt;  // What the frame shows here has been hidden or moved since.
    probe->node = scene->instances[*instance].node;
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
