#pragma once

#include <candela/environment.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>
#include <vector>

namespace candela {

using Radiance = std::function<glm::vec3(const glm::dvec3& direction)>;

inline glm::vec3 texelOf(const Image& picture, std::size_t index) {
    glm::vec3 color;
    std::memcpy(&color, picture.pixels.data() + index * 16, sizeof color);
    return color;
}

inline void setTexel(Image& picture, std::size_t index, const glm::vec4& color) {
    std::memcpy(picture.pixels.data() + index * 16, &color, sizeof color);
}

/// The direction of a texel's middle, by the words of `Environment::picture`.
inline glm::dvec3 directionOf(const Image& picture, std::uint32_t x, std::uint32_t y) {
    const double polar = std::numbers::pi * (y + 0.5) / picture.height;
    const double right = 2.0 * std::numbers::pi * ((x + 0.5) / picture.width - 0.5);
    return {std::sin(polar) * std::sin(right), std::cos(polar), -std::sin(polar) * std::cos(right)};
}

inline double solidAngleOf(const Image& picture, std::uint32_t y) {
    const double step = std::numbers::pi / picture.height;
    return 2.0 * std::numbers::pi / picture.width * (std::cos(y * step) - std::cos((y + 1) * step));
}

inline Environment pictureOf(std::uint32_t width, std::uint32_t height, const Radiance& radiance) {
    Environment environment;
    environment.picture = {"drawn", width, height, PixelFormat::rgba32f, {}};
    environment.picture.pixels.resize(std::size_t{width} * height * 16);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const glm::vec3 color = radiance(directionOf(environment.picture, x, y));
            setTexel(environment.picture, std::size_t{y} * width + x, glm::vec4(color, 1.0f));
        }
    }
    return environment;
}

/// The irradiance of a surface of this normal, in the picture's frame, by summation over the texels.
inline glm::dvec3 irradiance(const Image& picture, const glm::dvec3& normal) {
    glm::dvec3 sum(0.0);
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        const double solidAngle = solidAngleOf(picture, y);
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const double cosine = std::max(glm::dot(directionOf(picture, x, y), normal), 0.0);
            sum += cosine * solidAngle * glm::dvec3(texelOf(picture, std::size_t{y} * picture.width + x));
        }
    }
    return sum;
}

inline double luminance(const glm::dvec3& color) {
    return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
}

/// Normals to all sides.
inline std::vector<glm::dvec3> someNormals() {
    std::vector<glm::dvec3> normals;
    for (const double x : {-1.0, 0.0, 1.0}) {
        for (const double y : {-1.0, 0.0, 1.0}) {
            for (const double z : {-1.0, 0.0, 1.0}) {
                const glm::dvec3 normal(x, y, z);
                if (glm::length(normal) > 0.0) normals.push_back(glm::normalize(normal));
            }
        }
    }
    return normals;
}

}  // namespace candela
