#include "panels/color_values.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace {

float encoded(float linear) {
    const float value = std::clamp(linear, 0.0f, 1.0f);
    return value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1.0f / 2.4f) - 0.055f;
}

float decoded(float code) {
    return code <= 0.04045f ? code / 12.92f : std::pow((code + 0.055f) / 1.055f, 2.4f);
}

/// Linear Rec.709 from CIE XYZ; one column an XYZ channel. Source: IEC 61966-2-1, 5.2.
constexpr glm::dmat3 rec709FromXyz{3.2406,  -0.9689, 0.0557, -1.5372, 1.8758,
                                   -0.2040, -0.4986, 0.0415, 1.0570};

double cubic(double t, double a, double b, double c, double d) {
    return ((a * t + b) * t + c) * t + d;
}

/// CIE 1931 x and y of a black body.
glm::dvec2 chromaticity(double kelvin) {
    const double inverse = 1.0e3 / kelvin;
    const double x = kelvin <= 4000.0 ? cubic(inverse, -0.2661239, -0.2343589, 0.8776956, 0.179910)
                                      : cubic(inverse, -3.0258469, 2.1070379, 0.2226347, 0.240390);
    if (kelvin <= 2222.0) return {x, cubic(x, -1.1063814, -1.34811020, 2.18555832, -0.20219683)};
    if (kelvin <= 4000.0) return {x, cubic(x, -0.9549476, -1.37418593, 2.09137015, -0.16748867)};
    return {x, cubic(x, 3.0817580, -5.87338670, 3.75112997, -0.37001483)};
}

/// Mireds (1e6 / kelvin): equal steps of them look alike.
float kelvinOf(float mired) {
    return 1.0e6f / mired;
}

}  // namespace

SplitColor splitColor(const glm::vec3& color, const glm::vec3& hueOfBlack) {
    const float strength = std::max({color.r, color.g, color.b});
    if (strength <= 0.0f) return {hueOfBlack, 0.0f};
    return {color / strength, strength};
}

glm::vec3 srgbFromLinear(const glm::vec3& linear) {
    return {encoded(linear.r), encoded(linear.g), encoded(linear.b)};
}

glm::vec3 linearFromSrgb(const glm::vec3& codes) {
    return {decoded(codes.r), decoded(codes.g), decoded(codes.b)};
}

glm::vec3 colorOfTemperature(float kelvin) {
    const glm::dvec2 xy = chromaticity(std::clamp(kelvin, minTemperature, maxTemperature));
    const glm::dvec3 xyz(xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y);
    const glm::vec3 color = glm::max(glm::vec3(rec709FromXyz * xyz), glm::vec3(0.0f));
    return splitColor(color).hue;
}

float nearestTemperature(const glm::vec3& color) {
    const glm::vec3 hue = splitColor(color).hue;
    const auto distanceAt = [&](float mired) {
        return glm::distance(colorOfTemperature(kelvinOf(mired)), hue);
    };
    constexpr int steps = 64;
    constexpr float coolest = 1.0e6f / maxTemperature, warmest = 1.0e6f / minTemperature;
    constexpr float step = (warmest - coolest) / steps;
    const auto miredOf = [&](int index) { return coolest + step * static_cast<float>(index); };
    int nearest = 0;
    for (int i = 1; i <= steps; ++i)
        if (distanceAt(miredOf(i)) < distanceAt(miredOf(nearest))) nearest = i;
    float low = miredOf(std::max(nearest - 1, 0)), high = miredOf(std::min(nearest + 1, steps));
    // Ternary search: between the neighbours of the nearest step the distance has one minimum.
    for (int i = 0; i < 32; ++i) {
        const float third = (high - low) / 3.0f;
        if (distanceAt(low + third) < distanceAt(high - third)) {
            high -= third;
        } else {
            low += third;
        }
    }
    return kelvinOf(0.5f * (low + high));
}
