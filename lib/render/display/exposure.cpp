#include <candela/exposure.h>

#include "base/error_context.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace candela {

namespace {

/// Calls `visit` with the luminance of each pixel that shows a surface.
template <typename Visit>
void forEachSurface(const HdrImage& image, const glm::vec3& weights, const Visit& visit) {
    ErrorContext("HDR image")
        .requireCount("values", image.rgba.size(), "channels",
                      4 * static_cast<std::uint64_t>(std::max(image.width, 0)) *
                          static_cast<std::uint64_t>(std::max(image.height, 0)));
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        if (image.rgba[i + 3] <= 0.0f) continue;
        visit(weights.r * image.rgba[i] + weights.g * image.rgba[i + 1] + weights.b * image.rgba[i + 2]);
    }
}

}  // namespace

ExposureCounts countExposure(const HdrImage& radiance, const glm::vec3& luminanceWeights, double exposure) {
    // Half a code value of the linear part of sRGB's curve.
    constexpr double displayBlack = 0.5 / 255.0 / 12.92;
    const auto white = static_cast<float>(std::exp2(-exposure));
    const auto black = static_cast<float>(displayBlack * std::exp2(-exposure));
    ExposureCounts counts;
    forEachSurface(radiance, luminanceWeights, [&](float luminance) {
        ++counts.surfaces;
        counts.lit += luminance > 0.0f;
        counts.overBlack += luminance > black;
        counts.overWhite += luminance > white;
    });
    return counts;
}

std::optional<double> autoExposure(std::span<const HdrImage> frames, const glm::vec3& luminanceWeights) {
    std::vector<float> lit;
    for (const HdrImage& frame : frames) {
        forEachSurface(frame, luminanceWeights, [&](float luminance) {
            if (luminance > 0.0f && std::isfinite(luminance)) lit.push_back(luminance);
        });
    }
    if (lit.empty()) return std::nullopt;
    const auto middle = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 2);
    std::ranges::nth_element(lit, middle);
    constexpr double maxStops = 100.0;
    return std::clamp(std::log2(midGrey / *middle), -maxStops, maxStops);
}

}  // namespace candela
