#pragma once

#include <candela/image.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace candela {

/// A place in a picture, 0 to 1 from the left and from the top.
struct PicturePoint {
    float x, y;
};

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
    /// beyond the last row.
    glm::vec3 interpolated(const PicturePoint& point) const;

    /// Where a direction in the picture's frame, of any length over 0, is seen.
    static PicturePoint pointOf(const glm::vec3& direction);

  private:
    glm::vec3 rec709(std::uint32_t column, std::uint32_t row) const;

    const Image& picture_;
    glm::mat3 workingFromRec709_;
};

}  // namespace candela
