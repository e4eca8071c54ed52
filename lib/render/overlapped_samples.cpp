#include "render/renderer_state.h"

#include <algorithm>
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
    // Light of an environment takes passes of its own, and so do layers.
    const bool viewAlone = !scene.hasCages() && !scene.hasDeformations() && !scene.lights.hasSpheres() &&
                           !scene.environment && !scene.draws.hasTransparent();
    const bool hasLines = settings.overlays.wireframe || settings.overlays.cage;
    return onCpu && viewAlone && settings.debugView == DebugView::none && !hasLines;
}

void Renderer::State::drawSamples(GpuScene::State& scene, const SampleSpan& samples,
                                  const SampleViews& viewOf, SampleSums& sums) {
    std::vector<PassTime> times;
    addPasses(timer.results(), times);
    std::future<void> lit;  // Its destructor waits, also where something throws.
    for (std::uint32_t i = samples.first; i < samples.end; ++i) {
        startSample(scene, viewOf(i), i);
        // The last sample is the frame, of which the technique is asked for counts.
        CpuTiles& tiles = (samples.end - 1 - i) % 2 == 0 ? lighting.cpuTiles() : lighting.otherCpuTiles();
        {
            const gl::PassTimer::Scope pass(timer, "lighting");
            tiles.capture(lightingInputs(scene, frameSurfaces));
            if (lit.valid()) lit.get();
            const bool isLast = i + 1 == samples.end;
            lit =
                std::async(std::launch::async, [&tiles, &sums, isLast] { shadeSample(tiles, sums, isLast); });
            if (isLast) lit.get();
        }
        addPasses(timer.results(), times);
    }
    targets->memory = lighting.cpuTiles().result();
    shadowCounts = lighting.cpuTiles().shadowCounts();
    samplePasses = std::move(times);
}

}  // namespace candela
