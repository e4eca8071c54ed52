#include "scene/validate/scene_rules.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace candela {

namespace {

/// Whether every colour channel is 0 to `max`, which a NaN is not. Alpha is not read.
bool isRadiance(const std::vector<std::byte>& pixels, float max) {
    bool holds = true;
    for (std::size_t at = 0; at < pixels.size(); at += texelSize(PixelFormat::rgba32f)) {
        float color[3];
        std::memcpy(color, pixels.data() + at, sizeof color);
        for (const float channel : color) holds &= channel >= 0.0f && channel <= max;
    }
    return holds;
}

}  // namespace

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
    element.requireNotNegative("its intensity", environment.intensity);
    const float largest = std::numeric_limits<float>::max();
    element.require(isRadiance(picture.pixels, largest), "its radiance must be finite numbers, 0 or more");
    const float intensity = environment.intensity;
    const float max = intensity > 0.0f ? std::min(maxIntensity / intensity, largest) : largest;
    element.require(isRadiance(picture.pixels, max), "its intensity times its radiance must be at most 1e20");
    element.require(std::abs(glm::length(environment.rotation) - 1.0f) <= unitTolerance,
                    "its rotation must be a quaternion of unit length");
    if (environment.occlusionDistance)
        element.requirePositive("its occlusion distance", *environment.occlusionDistance);
}

}  // namespace candela
