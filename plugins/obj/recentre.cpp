#include <algorithm>
#include <cmath>
#include <limits>

#include "document.h"

namespace candela_plugins::obj {
namespace {

struct Range {
    float min = 0.0f, max = 0.0f;
};

/// Of the coordinate `axis` of the vertices that are drawn.
Range rangeOf(const Document& document, float Vec3::*axis) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Range range{infinity, -infinity};
    const auto add = [&](const Corner& corner) {
        if (corner.vertex >= document.positions.size()) return;
        if (std::isnan(document.positions[corner.vertex].x)) return;
        const float value = document.positions[corner.vertex].*axis;
        range = {std::min(range.min, value), std::max(range.max, value)};
    };
    std::for_each(document.corners.begin(), document.corners.end(), add);
    std::for_each(document.looseCorners.begin(), document.looseCorners.end(), add);
    return range;
}

/// A multiple of 1024 m, which is exact in single precision and leaves the bits below a millimetre; 0 where
/// it would gain nothing.
float originOf(const Range& range) {
    constexpr double step = 1024.0;
    const double center = 0.5 * (double{range.min} + double{range.max});
    const double halfExtent = 0.5 * (double{range.max} - double{range.min});
    if (halfExtent > 0.25 * std::abs(center)) return 0.0f;
    return static_cast<float>(std::round(center / step) * step);
}

}  // namespace

void recentre(Document& document) {
    if (document.residuals.empty() || (document.corners.empty() && document.looseCorners.empty())) return;
    document.residuals.resize(document.positions.size());
    for (float Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        const Range range = rangeOf(document, axis);
        if (range.min > range.max) return;  // No vertex is usable.
        const float origin = originOf(range);
        document.origin.*axis = origin;
        if (origin == 0.0f) continue;
        for (std::size_t i = 0; i < document.positions.size(); ++i) {
            float& position = document.positions[i].*axis;
            position =
                static_cast<float>(double{position} - double{origin} + double{document.residuals[i].*axis});
        }
    }
}

}  // namespace candela_plugins::obj
