#pragma once

#include <candela/image.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace candela {

/// The texels of an equirectangular picture (`Environment::picture`) in the working space.
class EnvironmentPicture {
  public:
    /// Refers to the picture, which `validate` accepts.
    EnvironmentPicture(const Image& picture, const glm::dmat3& workingFromRec709)
        : picture_(picture), workingFromRec709_(workingFromRec709) {}

    std::uint32_t width() const { return picture_.width; }
    std::uint32_t height() const { return picture_.height; }

    glm::vec3 texel(std::uint32_t column, std::uint32_t row) const;

    /// Bilinear between the centres of texels: across the border of the columns, and at the poles constant
    /// beyond the last row. `x` and `y` are in texels, from the left and from the top; centres are at
    /// 0.5, 1.5, ..., and `x` is 0 to the width.
    glm::vec3 interpolated(float x, float y) const;

    /// The interpolated radiance of a direction in the picture's frame, of any length over 0.
    glm::vec3 radiance(const glm::vec3& direction) const;

  private:
    glm::vec3 rec709(std::uint32_t column, std::uint32_t row) const;

    const Image& picture_;
    glm::mat3 workingFromRec709_;
};

}  // namespace candela
