#pragma once

#include <candela/image_file.h>

#include <glm/mat3x3.hpp>

#include <span>

namespace candela {

/// An RGB space that is known by its primaries and white.
struct KnownPrimaries {
    const char* name;
    Chromaticities chromaticities;
};

/// Rec.709, AP1 (ACEScg), AP0 (ACES2065-1), Rec.2020 and P3-D65, in this order.
std::span<const KnownPrimaries> knownPrimaries();

Chromaticities rec709Primaries();
Chromaticities ap0Primaries();
Chromaticities p3D65Primaries();

/// CIE XYZ of an RGB space's colours, white having Y = 1. After SMPTE RP 177-1993.
glm::dmat3 xyzFromRgb(const Chromaticities& primaries);

/// From one RGB space to another; white goes to white, by Bradford adaptation as in ACES (S-2014-004,
/// TB-2014-004).
glm::dmat3 rgbFromRgb(const Chromaticities& to, const Chromaticities& from);

/// The x, y coordinates of an XYZ colour.
glm::dvec2 chromaticity(const glm::dvec3& xyz);

}  // namespace candela
