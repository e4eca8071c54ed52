#include "render/environment/gpu_environment.h"
#include "render/renderer_state.h"

#include <algorithm>
#include <array>
#include <future>
#include <utility>

namespace candela {

namespace {

void addPasses(const std::vector<std::pair<std::string, double>>& added, std::vector<PassTime>& sums) {
    for (const auto& [name, milliseconds] : added) {
        const auto sum = std::ranges::find(sums, name, &PassTime::name);
        if (sum == sums.end())
            sums.push_back({name, milliseconds});
        else
            sum->milliseconds += milliseconds;
    }
}

/// The last sample stays in memory as the frame; others go to the sum alone.
void shadeSample(CpuTiles& tiles, SampleSums& sums, bool isLast) {
    if (isLast || tiles.hasEmission()) {
        tiles.shade();
        sums.addInMemory(tiles.result());
    } else {
        tiles.shadeOnto(sums.sumInMemory());
        sums.countInMemory(tiles.result().depth);
    }
}

}  // namespace

bool Renderer::State::canOverlapSamples(const GpuScene::State& scene) const {
    const FrameSettings& settings = frame->settings;
    const bool onCpu = frame->technique == Technique::tiles &&
                       lighting.tileBackend(settings.tileBackend) == TileBackend::cpu;
    // A background is drawn by the device, and layers take passes of their own.
    const bool isBackground = scene.environment && scene.environment->isBackground();
    const bool surfacesRest = !scene.hasCages() && !scene.hasDeformations() && !scene.draws.hasTransparent();
    // What has lobes may come into view in a later sample, and the targets are those of the first.
    const bool hasLobeWords = targets->parts.lobes == scene.materials.hasLobes();
    return onCpu && surfacesRest && hasLobeWords && !isBackground && settings.debugView == DebugView::none &&
           !hasLines(settings.overlays) && !hasHostSurfaces() && !settings.hooks.afterGeometry &&
           !settings.hooks.beforeDisplay;
}

void Renderer::State::startSample(GpuScene::State& scene, const CameraView& view, std::uint32_t sample,
                                  GBufferTargets& into) {
    ++frameNumber;
    targets->memory = {};
    FrameSettings settings = frame->settings;
    settings.sample = sample;
    scene.lights.setSample(sample);
    scene.update();
    describeFrame(scene, view, settings, frame->technique, frame->traced);
    timer.beginFrame();
    bindFrame();
    const gl::PassTimer::Scope pass(timer, "geometry");
    drawGeometry(scene, into, SurfaceSet::opaque, lighting.cpuTiles().radianceLoadOp());
    frameSurfaces.reset(*targets);
    frameSurfaces.emits = draws.emits();
}

std::array<GBufferTargets*, 2> Renderer::State::sampleTargets() {
    if (targets->depthMapping.data() == nullptr) return {targets, targets};
    if (otherSampleTargets && otherSampleTargets->parts != targets->parts) otherSampleTargets.reset();
    if (!otherSampleTargets)
        otherSampleTargets.emplace(targets->width, targets->height, targets->parts, targets->memoryDevice);
    return {targets, &*otherSampleTargets};
}

/// Lets `tiles` read all that the frame is lit from, and returns what finds the visibility of its environment
/// later, without OpenGL.
Renderer::State::FindVisibility Renderer::State::captureSample(const GpuScene::State& scene,
                                                               const GBufferTargets& drawn, CpuTiles& tiles) {
    ShadedSurfaces surfaces;
    surfaces.targets = &drawn;
    surfaces.emits = frameSurfaces.emits;
    LightingInputs inputs = lightingInputs(scene, surfaces);
    inputs.copy = nullptr;  // The tiles read for themselves.
    tiles.capture(inputs);
    if (scene.lights.hasSpheres()) tiles.keepLights(scene.lights);
    GBufferCopy& copy = tiles.captured();
    if (drawn.parts.occlusion) copy.occlusion();
    if (!frame->traced.environment)
        return [&drawn, &copy] { return drawn.parts.occlusion ? copy.occlusion().data() : nullptr; };
    copy.shadowWords();
    return [this, &scene, &drawn, &copy, uniforms = frame->uniforms, rays = environmentRays(scene)] {
        return traceOnCpu(scene, uniforms, rays, drawn.parts, copy);
    };
}

void Renderer::State::drawSamples(GpuScene::State& scene, const SampleSpan& samples,
                                  const SampleViews& viewOf, SampleSums& sums) {
    std::vector<PassTime> times;
    addPasses(timer.results(), times);
    const std::uint8_t* visible = nullptr;  // Of the sample that is lit.
    const std::array<GBufferTargets*, 2> drawn = sampleTargets();
    const auto mapped = drawn[0] == drawn[1] ? GBufferCopy::Mapped::copied : GBufferCopy::Mapped::inPlace;
    std::future<void> lit;  // Its destructor waits, also where something throws.
    for (std::uint32_t i = samples.first; i < samples.end; ++i) {
        // The last sample is the frame, whose targets are kept and of which the technique is asked for
        // counts.
        const std::size_t turn = (samples.end - 1 - i) % 2;
        startSample(scene, viewOf(i), i, *drawn[turn]);
        CpuTiles& tiles = turn == 0 ? lighting.cpuTiles() : lighting.otherCpuTiles();
        tiles.setMapped(mapped);
        {
            const gl::PassTimer::Scope pass(timer, "lighting");
            const FindVisibility find = captureSample(scene, *drawn[turn], tiles);
            if (lit.valid()) lit.get();
            const bool isLast = i + 1 == samples.end;
            lit = std::async(std::launch::async, [find, &visible, &tiles, &sums, isLast] {
                visible = find();
                tiles.setEnvironmentVisibility(visible);
                shadeSample(tiles, sums, isLast);
            });
            if (isLast) lit.get();
        }
        addPasses(timer.results(), times);
    }
    targets->memory = lighting.cpuTiles().result();
    shadowCounts = lighting.cpuTiles().shadowCounts();
    samplePasses = std::move(times);
    frameSurfaces.visibility.bytes = visible;
}

}  // namespace candela
