#include "render/environment/environment_picture.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>

namespace candela {

glm::vec3 EnvironmentPicture::rec709(std::uint32_t column, std::uint32_t row) const {
    const std::size_t at = (std::size_t{row} * picture_.width + column) * texelSize(PixelFormat::rgba32f);
    glm::vec3 value;
    std::memcpy(&value, picture_.pixels.data() + at, sizeof value);
    return value;
}

glm::vec3 EnvironmentPicture::texel(std::uint32_t column, std::uint32_t row) const {
    return workingFromRec709_ * rec709(column, row);
}

glm::vec3 EnvironmentPicture::interpolated(const PicturePoint& point) const {
    const float x = point.x * static_cast<float>(picture_.width),
                y = point.y * static_cast<float>(picture_.height);
    const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
    const auto width = static_cast<int>(picture_.width), height = static_cast<int>(picture_.height);
    const int column = static_cast<int>(left), row = static_cast<int>(top);
    const auto columnOf = [&](int i) { return static_cast<std::uint32_t>(i < 0 ? i + width : i % width); };
    const auto rowOf = [&](int i) { return static_cast<std::uint32_t>(std::clamp(i, 0, height - 1)); };
    const std::uint32_t columns[2] = {columnOf(column), columnOf(column + 1)},
                        rows[2] = {rowOf(row), rowOf(row + 1)};
    const float weightX = x - 0.5f - left, weightY = y - 0.5f - top;
    const glm::vec3 above = glm::mix(rec709(columns[0], rows[0]), rec709(columns[1], rows[0]), weightX);
    const glm::vec3 below = glm::mix(rec709(columns[0], rows[1]), rec709(columns[1], rows[1]), weightX);
    return workingFromRec709_ * glm::mix(above, below, weightY);
}

PicturePoint EnvironmentPicture::pointOf(const glm::vec3& direction) {
    constexpr float pi = std::numbers::pi_v<float>;
    const float across = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    return {0.5f + std::atan2(direction.x, -direction.z) / (2.0f * pi), std::atan2(across, direction.y) / pi};
}

}  // namespace candela
