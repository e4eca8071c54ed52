#include <algorithm>
#include <cmath>

#include "document.h"

namespace candela_plugins::obj {
namespace {

struct Range {
    float min = 0.0f, max = 0.0f;
};

/// Of the coordinate `axis` of the vertices that faces use.
Range rangeOf(const Document& document, float Vec3::*axis) {
    const float first = document.positions[document.corners[0].vertex].*axis;
    Range range{first, first};
    for (const Corner& corner : document.corners) {
        const float value = document.positions[corner.vertex].*axis;
        range = {std::min(range.min, value), std::max(range.max, value)};
    }
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
    if (document.residuals.empty() || document.corners.empty()) return;
    document.residuals.resize(document.positions.size());
    for (float Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        const float origin = originOf(rangeOf(document, axis));
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
