#include "picture.h"

#include "common/deferred_signals.h"

#include <candela/image_file.h>

#include <array>
#include <chrono>

namespace {

/// The picture is what light leaves the scene; black where there is none, never see-through.
void makeOpaque(std::vector<std::uint8_t>& rgba) {
    for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 255;
}

/// R, G, B and A as a plane each.
std::array<std::vector<float>, 4> splitPlanes(const std::vector<float>& rgba) {
    std::array<std::vector<float>, 4> planes;
    for (std::size_t channel = 0; channel < planes.size(); ++channel) {
        planes[channel].reserve(rgba.size() / 4);
        for (std::size_t i = channel; i < rgba.size(); i += 4) planes[channel].push_back(rgba[i]);
    }
    return planes;
}

}  // namespace

Painter::Painter(candela::Renderer& renderer, candela::GpuScene& scene, const candela::ColorConfig& color,
                 const std::optional<candela::DisplayTransform>& display, const Options& options)
    : renderer_(renderer), scene_(scene), color_(color), display_(display), options_(options) {}

FrameTiming Painter::draw(const candela::View& view) {
    candela::FrameInputs inputs;
    inputs.width = options_.width;
    inputs.height = options_.height;
    inputs.view = view;
    inputs.brdf = options_.brdf;
    inputs.technique = options_.technique;

    const auto start = std::chrono::steady_clock::now();
    renderer_.render(scene_, inputs);
    if (display_) pixels_ = renderer_.displayPicture(*display_);
    FrameTiming timing;
    timing.passes = renderer_.passTimes();  // waits for the frame to end
    timing.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return timing;
}

void Painter::write(const std::filesystem::path& path) {
    if (!display_) return writeRadiance(path);
    makeOpaque(pixels_);
    const DeferredSignals deferred;
    candela::writePng(path, static_cast<std::uint32_t>(options_.width),
                      static_cast<std::uint32_t>(options_.height), pixels_, display_->encoding());
}

void Painter::writeRadiance(const std::filesystem::path& path) {
    const std::array<std::vector<float>, 4> planes = splitPlanes(renderer_.radiance().rgba);
    std::vector<candela::ExrChannel> channels;
    constexpr std::array names{"R", "G", "B", "A"};
    for (std::size_t i = 0; i < planes.size(); ++i) channels.push_back({names[i], planes[i]});

    std::vector<candela::Aov> aovs;
    if (!options_.aovs.empty()) aovs = renderer_.aovs(scene_, options_.aovs);
    for (const candela::Aov& aov : aovs)
        for (std::size_t i = 0; i < aov.channels.size(); ++i)
            channels.push_back({aov.channels[i], aov.values[i]});

    const DeferredSignals deferred;
    candela::writeExr(path, static_cast<std::uint32_t>(options_.width),
                      static_cast<std::uint32_t>(options_.height), channels, color_.chromaticities());
}
