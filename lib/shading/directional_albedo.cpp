#include "shading/directional_albedo.h"

#include <candela/brdf.h>
#include <candela/error.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace candela {
namespace {

constexpr int azimuthSamples = 24;
constexpr int heightSamples = 24;
constexpr int bisectionSteps = 14;

/// Smith's Lambda for GGX. Source: Heitz 2014, equation 72.
double smithLambda(double nDotW, double alpha) {
    const double tangentSquared = 1.0 / (nDotW * nDotW) - 1.0;
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * tangentSquared) - 1.0);
}

/// One row of directions of the quadrature: normals visible from `v`, at one azimuth. They come from points
/// of a spherical cap of which equal areas are equally likely, after Dupuy and Benyoub, "Sampling visible GGX
/// normals with spherical caps", 2023. `height`, 0 to 1, is the point's height in the cap.
struct VisibleNormals {
    glm::dvec3 v, stretched;
    double alpha, cosAzimuth;

    /// n·l of the reflection of `v` about the normal at `height`; below 0 under the horizon.
    double nDotL(double height) const {
        const double halfZ = height * (1.0 + stretched.z);
        const double z = halfZ - stretched.z;
        const double radiusSquared = std::max(0.0, 1.0 - z * z);
        const double along = std::sqrt(radiusSquared) * cosAzimuth;
        const double halfX = stretched.x + along;
        const double tangentSquared = stretched.x * (halfX + along) + radiusSquared;
        const double lengthSquared = alpha * alpha * tangentSquared + halfZ * halfZ;
        return 2.0 * (v.x * alpha * halfX + v.z * halfZ) * halfZ / lengthSquared - v.z;
    }

    /// The height below which reflections leave under the horizon, found in the logarithm because it scales
    /// with alpha.
    double horizon() const {
        double below = std::log(1.0e-7);
        double above = 0.0;
        if (nDotL(std::exp(below)) >= 0.0) return std::exp(below);
        for (int step = 0; step < bisectionSteps; ++step) {
            const double middle = 0.5 * (below + above);
            (nDotL(std::exp(middle)) < 0.0 ? below : above) = middle;
        }
        return std::exp(above);
    }
};

/// The part of one azimuth's visible normals that reflects above the horizon and is not shadowed there:
/// f_s (n·l) over the density of visible normals is G2 / G1(v). Midpoint rule, with the samples concentrated
/// at the horizon, where the integrand is steep.
double azimuthAlbedo(const VisibleNormals& normals) {
    const double masking = 1.0 + smithLambda(normals.v.z, normals.alpha);
    const double start = normals.horizon();
    double sum = 0.0;
    for (int i = 0; i < heightSamples; ++i) {
        const double s = (i + 0.5) / heightSamples;
        const double nDotL = std::min(normals.nDotL(start + (1.0 - start) * s * s), 1.0);
        if (nDotL <= 0.0) continue;
        sum += 2.0 * s * masking / (masking + smithLambda(nDotL, normals.alpha));
    }
    return (1.0 - start) * sum / heightSamples;
}

/// The albedo. The lobe is mirror-symmetric: half of the azimuths suffice.
double integrateAlbedo(double nDotV, double alpha) {
    const glm::dvec3 v(std::sqrt(1.0 - nDotV * nDotV), 0.0, nDotV);
    VisibleNormals normals{v, glm::normalize(glm::dvec3(alpha * v.x, 0.0, v.z)), alpha, 0.0};
    double sum = 0.0;
    for (int i = 0; i < azimuthSamples; ++i) {
        normals.cosAzimuth = std::cos(std::numbers::pi * (i + 0.5) / azimuthSamples);
        sum += azimuthAlbedo(normals);
    }
    return sum / azimuthSamples;
}

/// The table's entry at x. At x = 0, exact grazing, masking outweighs shadowing and E is 1 for every alpha.
double tableEntry(double x, double alpha) {
    if (x == 0.0) return 1.0;
    const double nDotV = std::min(1.0, x * alpha / (1.0 + alpha - x));
    return std::min(1.0, integrateAlbedo(nDotV, alpha) + albedoBias);
}

using AlbedoTable = std::array<float, std::size_t{albedoTableSize} * albedoTableSize>;

AlbedoTable computeTable() {
    AlbedoTable table{};
    constexpr double last = albedoTableSize - 1;
    for (int j = 0; j < albedoTableSize; ++j) {
        const double alpha = glm::mix(minAlpha, 1.0, j / last);
        for (int i = 0; i < albedoTableSize; ++i)
            table[std::size_t(j * albedoTableSize + i)] = float(tableEntry(i / last, alpha));
    }
    return table;
}

}  // namespace

std::span<const float> directionalAlbedoTable() {
    static const AlbedoTable table = computeTable();
    return table;
}

// As `directionalAlbedo` of shaders/lib/lighting.glsl.
double directionalAlbedo(double nDotV, double alpha) {
    // No number compares as true with NaN.
    if (!(std::abs(nDotV) <= 1.0 + 1.0e-3) || !(alpha >= 0.0 && alpha <= 1.0)) {
        throw Error(ErrorKind::badInput, "",
                    "the directional albedo was requested for n·v = " + std::to_string(nDotV) +
                        " and alpha = " + std::to_string(alpha) + "; n·v has to be a cosine, alpha 0 to 1");
    }
    nDotV = std::clamp(nDotV, minNDotV, 1.0);
    alpha = std::clamp(alpha, minAlpha, 1.0);
    constexpr int last = albedoTableSize - 1;
    const double x = last * nDotV * (1.0 + alpha) / (nDotV + alpha);
    const double y = last * (alpha - minAlpha) / (1.0 - minAlpha);
    const int i = std::min(int(x), last - 1);
    const int j = std::min(int(y), last - 1);
    const float* texel = directionalAlbedoTable().data() + j * albedoTableSize + i;
    const double low = glm::mix(double(texel[0]), double(texel[1]), x - i);
    const double high = glm::mix(double(texel[albedoTableSize]), double(texel[albedoTableSize + 1]), x - i);
    return glm::mix(low, high, y - j);
}

}  // namespace candela
