#include "support/skies.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>
#include <numbers>

namespace candela::test {

namespace {

constexpr double pi = std::numbers::pi;

glm::dvec3 texelDirection(std::uint32_t column, std::uint32_t row, const Image& picture) {
    const double azimuth = 2.0 * pi * ((column + 0.5) / picture.width - 0.5),
                 polar = pi * (row + 0.5) / picture.height;
    return {std::sin(azimuth) * std::sin(polar), std::cos(polar), -std::cos(azimuth) * std::sin(polar)};
}

glm::vec3 gradient(const glm::dvec3& direction) {
    if (direction.y < 0.0) return {0.1f, 0.09f, 0.08f};
    return glm::mix(glm::vec3(0.9f, 1.0f, 1.1f), glm::vec3(0.2f, 0.4f, 1.0f),
                    static_cast<float>(direction.y));
}

bool isWithin(const glm::dvec3& direction, const glm::dvec3& middle, double angle) {
    return glm::dot(direction, glm::normalize(middle)) > std::cos(angle);
}

glm::vec3 checker(const glm::dvec3& direction) {
    const double azimuth = std::atan2(direction.x, -direction.z) / (2.0 * pi) + 0.5,
                 polar = std::acos(glm::clamp(direction.y, -1.0, 1.0)) / pi;
    return (static_cast<int>(azimuth * 16.0) + static_cast<int>(polar * 8.0)) % 2 == 0
               ? glm::vec3(1.0f, 0.5f, 0.1f)
               : glm::vec3(0.02f, 0.1f, 0.3f);
}

glm::vec3 softBoxes(const glm::dvec3& direction) {
    const auto inBox = [&](const glm::dvec3& middle, double halfWidth, double halfHeight) {
        const glm::dvec3 forward = glm::normalize(middle),
                         right = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 1.0, 0.0))),
                         up = glm::cross(right, forward);
        const double depth = glm::dot(direction, forward);
        return depth > 0.0 && std::abs(glm::dot(direction, right)) < halfWidth * depth &&
               std::abs(glm::dot(direction, up)) < halfHeight * depth;
    };
    if (inBox({1.0, 0.8, -0.6}, 0.4, 0.25)) return glm::vec3(12.0f);
    if (inBox({-1.0, 0.3, -0.4}, 0.2, 0.6)) return glm::vec3(5.0f, 4.5f, 4.0f);
    if (inBox({0.1, 0.5, 1.0}, 0.9, 0.1)) return glm::vec3(3.0f, 4.0f, 5.0f);
    return glm::vec3(0.03f);
}

glm::vec3 sun(const glm::dvec3& direction, double radius, float brightness) {
    const glm::vec3 sky = gradient(direction);
    return isWithin(direction, {0.5, 0.6, -0.7}, radius) ? sky + brightness * glm::vec3(1.0f, 0.9f, 0.7f)
                                                         : sky;
}

}  // namespace

Image makeSky(std::uint32_t width, const std::function<glm::vec3(const glm::dvec3&)>& radiance) {
    Image picture{"sky", width, width / 2, PixelFormat::rgba32f, {}};
    picture.pixels.resize(std::size_t{picture.width} * picture.height * texelSize(picture.format));
    std::byte* texel = picture.pixels.data();
    for (std::uint32_t row = 0; row < picture.height; ++row) {
        for (std::uint32_t column = 0; column < picture.width; ++column, texel += 16) {
            const glm::vec3 value = radiance(texelDirection(column, row, picture));
            std::memcpy(texel, &value, sizeof value);
        }
    }
    return picture;
}

std::vector<SkyTexel> texelsOf(const Image& picture) {
    std::vector<SkyTexel> texels;
    const std::byte* texel = picture.pixels.data();
    for (std::uint32_t row = 0; row < picture.height; ++row) {
        const double top = std::cos(pi * row / picture.height),
                     bottom = std::cos(pi * (row + 1.0) / picture.height);
        for (std::uint32_t column = 0; column < picture.width; ++column, texel += 16) {
            glm::vec3 value;
            std::memcpy(&value, texel, sizeof value);
            texels.push_back({texelDirection(column, row, picture), 2.0 * pi / picture.width * (top - bottom),
                              glm::dvec3(value)});
        }
    }
    return texels;
}

std::vector<NamedSky> skies(std::uint32_t width) {
    return {{"constant", makeSky(width, [](const glm::dvec3&) { return glm::vec3(1.0f, 0.8f, 0.6f); })},
            {"gradient", makeSky(width, gradient)},
            {"sun", makeSky(width, [](const glm::dvec3& d) { return sun(d, 0.03, 1000.0f); })},
            {"checker", makeSky(width, checker)},
            {"soft boxes", makeSky(width, softBoxes)}};
}

NamedSky hardSun(std::uint32_t width) {
    return {"hard sun", makeSky(width, [](const glm::dvec3& d) { return sun(d, 0.009, 50000.0f); })};
}

std::vector<glm::dvec3> sphereDirections(int count) {
    std::vector<glm::dvec3> directions;
    const double step = pi * (3.0 - std::sqrt(5.0));
    for (int i = 0; i < count; ++i) {
        const double y = 1.0 - (2.0 * i + 1.0) / count, across = std::sqrt(1.0 - y * y);
        directions.emplace_back(across * std::cos(step * i), y, across * std::sin(step * i));
    }
    return directions;
}

}  // namespace candela::test
