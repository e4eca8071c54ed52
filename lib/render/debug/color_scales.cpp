#include "render/debug/color_scales.h"

#include <candela/renderer.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>

namespace candela {

glm::vec3 levelColor(std::uint32_t level) {
    assert(level < levelColors.size());
    return levelColors[level];
}

glm::vec3 heatColor(float share) {
    constexpr std::size_t steps = heatStops.size() - 1;
    const float position = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(steps);
    const std::size_t step = std::min(static_cast<std::size_t>(position), steps - 1);
    return glm::mix(heatStops[step], heatStops[step + 1], position - static_cast<float>(step));
}

const char* toString(DebugView show) {
    switch (show) {
        case DebugView::normals:
            return "normals";
        case DebugView::level:
            return "level";
        case DebugView::baseColor:
            return "base_color";
        case DebugView::metallic:
            return "metallic";
        case DebugView::roughness:
            return "roughness";
        case DebugView::depth:
            return "depth";
        case DebugView::emission:
            return "emission";
        case DebugView::lightCount:
            return "light_count";
        default:
            return "picture";
    }
}

}  // namespace candela
