#include "scene/validate/scene_rules.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace candela {

namespace {

/// Whether every colour channel is 0 or more and finite, which a NaN is not. Alpha is not read.
bool isRadiance(const std::vector<std::byte>& pixels) {
    constexpr float max = std::numeric_limits<float>::max();
    bool holds = true;
    for (std::size_t at = 0; at < pixels.size(); at += texelSize(PixelFormat::rgba32f)) {
        float color[3];
        std::memcpy(color, pixels.data() + at, sizeof color);
        for (const float channel : color) holds &= channel >= 0.0f && channel <= max;
    }
    return holds;
}

}  // namespace

float largestRadiance(const Image& picture) {
    float largest = 0.0f;
    for (std::size_t at = 0; at < picture.pixels.size(); at += texelSize(PixelFormat::rgba32f)) {
        float color[3];
        std::memcpy(color, picture.pixels.data() + at, sizeof color);
        for (const float channel : color) largest = std::max(largest, channel);
    }
    return largest;
}

void validateEnvironmentSettings(const EnvironmentSettings& settings, float largest,
                                 const ErrorContext& element) {
    element.requireNotNegative("its intensity", settings.intensity);
    element.require(double{settings.intensity} * double{largest} <= double{maxIntensity},
                    "its intensity times its radiance must be at most 1e20");
    element.require(std::abs(glm::length(settings.rotation) - 1.0f) <= unitTolerance,
                    "its rotation must be a quaternion of unit length");
    if (settings.occlusionDistance)
        element.requirePositive("its occlusion distance", *settings.occlusionDistance);
}

void validateEnvironment(const Environment& environment) {
    constexpr std::uint32_t maxSide = 32768;
    const Image& picture = environment.picture;
    const ErrorContext element("environment", {}, picture.name);
    element.require(picture.format == PixelFormat::rgba32f, "its picture's pixels must be 32-bit floats");
    element.require(
        picture.width >= 1 && picture.width <= maxSide && picture.height >= 1 && picture.height <= maxSide,
        "its picture's width and height must lie between 1 and 32768");
    const std::size_t size = std::size_t{picture.width} * picture.height * texelSize(picture.format);
    if (picture.pixels.size() != size)
        element.refuse("holds " + std::to_string(picture.pixels.size()) +
                       " bytes of pixels, but its size requires " + std::to_string(size));
    element.require(isRadiance(picture.pixels), "its radiance must be finite numbers, 0 or more");
    validateEnvironmentSettings({environment.rotation, environment.intensity, environment.isBackground,
                                 environment.occlusionDistance},
                                largestRadiance(picture), element);
}

}  // namespace candela
