// Draws a picture with read-back for each line of standard input, and prints what it took in milliseconds:
// what compare_read_back.py compares the Python package with.

#include <candela/candela.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>

namespace {

using Clock = std::chrono::steady_clock;

const std::vector<std::string> aovs{"Z", "N"};

// The arrays are read and dropped, as a caller has them.
double drawn(candela::Renderer& renderer, candela::Accumulator& accumulator, candela::GpuScene& scene,
             const candela::CameraView& view, const candela::FrameSettings& settings,
             const candela::SamplingSettings& sampling) {
    const auto start = Clock::now();
    if (sampling.count == 1) {
        const candela::Frame frame = renderer.render(scene, view, settings);
        const std::vector<candela::Aov> values = frame.aovs(aovs);
        const candela::HdrImage radiance = frame.radiance();
    } else {
        accumulator.reset();
        accumulator.addSamples(renderer, scene, view, settings, sampling, 0, sampling.count);
        const std::vector<candela::Aov> values = accumulator.aovs();
        const candela::HdrImage radiance = accumulator.radiance();
    }
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 5) {
        std::cerr << "usage: read_back SCENE WIDTH HEIGHT SAMPLES\n";
        return 2;
    }
    const candela::Scene scene = candela::importScene(candela::PluginRegistry(), arguments[1]).scene;
    const candela::Context context = candela::Context::createHeadless();
    candela::GpuScene gpuScene(context, scene);
    candela::Renderer renderer(context);
    candela::Accumulator accumulator(context, {aovs, candela::AovFilter::automatic});
    candela::FrameSettings settings;
    settings.width = std::atoi(arguments[2]);
    settings.height = std::atoi(arguments[3]);
    candela::SamplingSettings sampling;
    sampling.count = static_cast<std::uint32_t>(std::atoi(arguments[4]));
    const candela::CameraView view = candela::cameraView(scene, 0, candela::worldTransforms(scene));
    for (std::string line; std::getline(std::cin, line);)
        std::cout << drawn(renderer, accumulator, gpuScene, view, settings, sampling) << std::endl;
}
