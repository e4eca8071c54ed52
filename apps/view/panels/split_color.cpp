#include "panels/split_color.h"

#include <algorithm>

SplitColor splitColor(const glm::vec3& color, const glm::vec3& hueOfBlack) {
    const float greatest = std::max({color.r, color.g, color.b});
    if (greatest <= 0.0f) return {hueOfBlack, 0.0f};
    return {color / greatest, greatest};
}
