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

}  // namespace

bool Renderer::State::canOverlapSamples(const GpuScene::State& scene) const {
    const FrameSettings& settings = frame->settings;
    const bool onCpu = frame->technique == Technique::tiles &&
                       lighting.tileBackend(settings.tileBackend) == TileBackend::cpu;
    // Light of an environment takes passes of its own.
    const bool viewAlone =
        !scene.hasCages() && !scene.hasDeformations() && !scene.lights.hasSpheres() && !scene.environment;
    const bool hasLines = settings.overlays.wireframe || settings.overlays.cage;
    return onCpu && viewAlone && settings.debugView == DebugView::none && !hasLines;
}

void Renderer::State::drawSamples(GpuScene::State& scene, const SampleSpan& samples,
                                  const SampleViews& viewOf,
                                  const std::function<void(const GBufferTargets::Memory&)>& add) {
    std::vector<PassTime> sums;
    addPasses(timer.results(), sums);
    std::future<void> lit;  // Its destructor waits, also where something throws.
    for (std::uint32_t i = samples.first; i < samples.end; ++i) {
        startSample(scene, viewOf(i), i);
        // The last sample is the frame, of which the technique is asked for counts.
        CpuTiles& tiles = (samples.end - 1 - i) % 2 == 0 ? lighting.cpuTiles() : lighting.otherCpuTiles();
        {
            const gl::PassTimer::Scope pass(timer, "lighting");
            tiles.capture(lightingInputs(scene));
            if (lit.valid()) lit.get();
            lit = std::async(std::launch::async, [&tiles, &add] {
                tiles.shade();
                add(tiles.result());
            });
            if (i + 1 == samples.end) lit.get();
        }
        addPasses(timer.results(), sums);
    }
    targets->memory = lighting.cpuTiles().result();
    shadowCounts = lighting.cpuTiles().shadowCounts();
    samplePasses = std::move(sums);
}

}  // namespace candela
