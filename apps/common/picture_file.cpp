#include "picture_file.h"

#include "deferred_signals.h"

#include <candela/image_file.h>

#include <array>
#include <cstddef>

namespace {

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

void writeShownPicture(const std::filesystem::path& path, int width, int height,
                       std::vector<std::uint8_t> rgba, const candela::DisplayTransform& display) {
    for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 255;
    const DeferredSignals deferred;
    candela::writePng(path, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), rgba,
                      display.encoding());
}

void writeRadiance(const std::filesystem::path& path, const candela::Frame& frame, const std::vector<std::string>& aovs,
                   const candela::ColorConfig& color) {
    const candela::HdrImage picture = frame.radiance();
    const std::array<std::vector<float>, 4> planes = splitPlanes(picture.rgba);
    std::vector<candela::ExrChannel> channels;
    constexpr std::array names{"R", "G", "B", "A"};
    for (std::size_t i = 0; i < planes.size(); ++i) channels.push_back({names[i], planes[i]});

    std::vector<candela::Aov> values;
    if (!aovs.empty()) values = frame.aovs(aovs);
    for (const candela::Aov& aov : values)
        for (std::size_t i = 0; i < aov.channels.size(); ++i)
            channels.push_back({aov.channels[i], aov.values[i]});

    const DeferredSignals deferred;
    candela::writeExr(path, static_cast<std::uint32_t>(picture.width),
                      static_cast<std::uint32_t>(picture.height), channels, color.chromaticities());
}
