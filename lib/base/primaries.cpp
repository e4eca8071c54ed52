#include "base/primaries.h"

#include <array>

namespace candela {

namespace {

// ITU-R BT.709-6, SMPTE ST 2065-1 (AP0), AMPAS S-2014-004 (AP1), ITU-R BT.2020-2, SMPTE EG 432-1 with D65.
const std::array known{
    KnownPrimaries{"Rec.709", Chromaticities{}},
    KnownPrimaries{"AP1", Chromaticities{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}}},
    KnownPrimaries{"AP0", Chromaticities{{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.077}, {0.32168, 0.33767}}},
    KnownPrimaries{"Rec.2020",
                   Chromaticities{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}}},
    KnownPrimaries{"P3-D65",
                   Chromaticities{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}}},
};

glm::dvec3 xyzOf(const glm::dvec2& xy) {
    return {xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y};
}

glm::dmat3 adaptation(const glm::dvec2& fromWhite, const glm::dvec2& toWhite) {
    // The Bradford cone response, column by column.
    const glm::dmat3 cones{{0.8951, -0.7502, 0.0389}, {0.2664, 1.7135, -0.0685}, {-0.1614, 0.0367, 1.0296}};
    const glm::dvec3 gain = (cones * xyzOf(toWhite)) / (cones * xyzOf(fromWhite));
    const glm::dmat3 scale{{gain.x, 0.0, 0.0}, {0.0, gain.y, 0.0}, {0.0, 0.0, gain.z}};
    return glm::inverse(cones) * scale * cones;
}

}  // namespace

std::span<const KnownPrimaries> knownPrimaries() {
    return known;
}
Chromaticities rec709Primaries() {
    return known[0].chromaticities;
}
Chromaticities ap0Primaries() {
    return known[2].chromaticities;
}
Chromaticities p3D65Primaries() {
    return known[4].chromaticities;
}

glm::dmat3 xyzFromRgb(const Chromaticities& primaries) {
    const auto column = [](const glm::dvec2& xy) { return glm::dvec3(xy.x, xy.y, 1.0 - xy.x - xy.y); };
    const glm::dmat3 directions{column(primaries.red), column(primaries.green), column(primaries.blue)};
    const glm::dvec3 strength = glm::inverse(directions) * xyzOf(primaries.white);
    return {directions[0] * strength.x, directions[1] * strength.y, directions[2] * strength.z};
}

glm::dmat3 rgbFromRgb(const Chromaticities& to, const Chromaticities& from) {
    return glm::inverse(xyzFromRgb(to)) * adaptation(from.white, to.white) * xyzFromRgb(from);
}

glm::dvec2 chromaticity(const glm::dvec3& xyz) {
    return glm::dvec2(xyz) / (xyz.x + xyz.y + xyz.z);
}

}  // namespace candela
