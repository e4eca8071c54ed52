#pragma once

#include "scene/environment/portable_math.h"

#include <candela/environment.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// The directions and solid angles of the texels of an equirectangular picture, in the picture's frame (see
/// `Environment::picture`).
class Equirect {
  public:
    Equirect(std::uint32_t width, std::uint32_t height) : width_(width), height_(height) {
        for (std::uint32_t column = 0; column < width; ++column) {
            const double angle = azimuth(column);
            sines_.push_back(portableSin(angle));
            cosines_.push_back(portableCos(angle));
        }
    }

    std::uint32_t width() const { return width_; }
    std::uint32_t height() const { return height_; }

    /// What a row's texels have in common.
    struct Row {
        double sine, cosine;  ///< Of the angle to +Y at the row's middle.
        double solidAngle;    ///< Of one texel, steradian.
    };
    Row row(std::uint32_t row) const {
        constexpr double pi = std::numbers::pi;
        const double step = pi / height_, angle = (row + 0.5) * step;
        // cos(top) - cos(bottom) = 2 sin(middle) sin(step / 2)
        const double sine = portableSin(angle);
        return {sine, portableCos(angle), 2.0 * pi / width_ * 2.0 * sine * portableSin(0.5 * step)};
    }
    glm::dvec3 direction(std::uint32_t column, const Row& row) const {
        return {row.sine * sines_[column], row.cosine, -row.sine * cosines_[column]};
    }

  private:
    /// From -Z towards +X, -pi to pi.
    double azimuth(std::uint32_t column) const {
        return std::numbers::pi * (2.0 * (column + 0.5) / width_ - 1.0);
    }

    std::uint32_t width_, height_;
    std::vector<double> sines_, cosines_;
};

/// Luminance of linear Rec.709 (ITU-R BT.709-6).
inline double luminanceOf(const glm::dvec3& color) {
    return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
}

/// A black picture of an environment, and its numbers: 4 a texel.
inline Image blackPicture(const char* name, std::uint32_t width, std::uint32_t height) {
    Image image{name, width, height, PixelFormat::rgba32f, {}};
    image.pixels.resize(std::size_t{width} * height * texelSize(image.format));
    return image;
}
inline std::span<float> numbersOf(Image& image) {
    return {reinterpret_cast<float*>(image.pixels.data()), image.pixels.size() / sizeof(float)};
}
inline std::span<const float> numbersOf(const Image& image) {
    return {reinterpret_cast<const float*>(image.pixels.data()), image.pixels.size() / sizeof(float)};
}

}  // namespace candela
