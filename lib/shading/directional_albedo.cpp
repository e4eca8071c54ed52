#include "shading/directional_albedo.h"

#include "base/thread_pool.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace candela {
namespace {

constexpr int azimuthSamples = 24;
constexpr int heightSamples = 24;
constexpr int bisectionSteps = 14;

/// n·v of the first column, which is that of exact grazing.
constexpr double grazingNDotV = 1.0e-7;

/// Smith's Lambda for GGX. Source: Heitz 2014, equation 72.
double smithLambda(double nDotW, double alpha) {
    const double tangentSquared = 1.0 / (nDotW * nDotW) - 1.0;
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * tangentSquared) - 1.0);
}

/// k of `course`, and the factor of its masking for one direction.
double schlickSmithK(double roughness) {
    return (roughness + 1.0) * (roughness + 1.0) / 8.0;
}
double schlickSmithSide(double nDotW, double k) {
    return nDotW / (nDotW * (1.0 - k) + k);
}

double fifthPower(double a) {
    return a * a * a * a * a;
}

struct Lobe {
    BrdfModel model;
    double alpha, k;

    Lobe(BrdfModel ofModel, double roughness)
        : model(ofModel), alpha(std::max(roughness * roughness, minAlpha)), k(schlickSmithK(roughness)) {}

    /// f_s (n·l) for F = 1, over the density of visible normals' reflections, D G1(v) / (4 n·v).
    double weight(double nDotL, double nDotV) const {
        const double masking = 1.0 + smithLambda(nDotV, alpha);  // 1 / G1(v)
        if (model == BrdfModel::gltf) return masking / (masking + smithLambda(nDotL, alpha));
        return schlickSmithSide(nDotL, k) * schlickSmithSide(nDotV, k) * masking;
    }
};

/// A reflection of `v`.
struct Reflection {
    double nDotL;  ///< Below 0 under the horizon.
    double vDotH;
};

/// One row of directions of the quadrature: normals visible from `v`, at one azimuth. They come from points
/// of a spherical cap of which equal areas are equally likely, after Dupuy and Benyoub, "Sampling visible GGX
/// normals with spherical caps", 2023. `height`, 0 to 1, is the point's height in the cap.
struct VisibleNormals {
    glm::dvec3 v, stretched;
    double alpha, cosAzimuth;

    /// About the normal at `height`.
    Reflection reflection(double height) const {
        const double halfZ = height * (1.0 + stretched.z);
        const double z = halfZ - stretched.z;
        const double radiusSquared = std::max(0.0, 1.0 - z * z);
        const double along = std::sqrt(radiusSquared) * cosAzimuth;
        const double halfX = stretched.x + along;
        const double tangentSquared = stretched.x * (halfX + along) + radiusSquared;
        const double lengthSquared = alpha * alpha * tangentSquared + halfZ * halfZ;
        const double vDotHalf = v.x * alpha * halfX + v.z * halfZ;
        return {2.0 * vDotHalf * halfZ / lengthSquared - v.z, vDotHalf / std::sqrt(lengthSquared)};
    }

    /// The height below which reflections leave under the horizon, found in the logarithm because it scales
    /// with alpha.
    double horizon() const {
        double below = std::log(1.0e-7);
        double above = 0.0;
        if (reflection(std::exp(below)).nDotL >= 0.0) return std::exp(below);
        for (int step = 0; step < bisectionSteps; ++step) {
            const double middle = 0.5 * (below + above);
            (reflection(std::exp(middle)).nDotL < 0.0 ? below : above) = middle;
        }
        return std::exp(above);
    }
};

/// The integral of the lobe for F = 1, and of the lobe times Schlick's weight.
struct Integrals {
    double lobe = 0.0, schlick = 0.0;
};

/// The part of one azimuth's visible normals that reflects above the horizon. Midpoint rule, with the samples
/// concentrated at the horizon, where the integrand is steep.
Integrals azimuthIntegrals(const Lobe& lobe, const VisibleNormals& normals) {
    const double start = normals.horizon();
    Integrals sum;
    for (int i = 0; i < heightSamples; ++i) {
        const double s = (i + 0.5) / heightSamples;
        const Reflection reflection = normals.reflection(start + (1.0 - start) * s * s);
        if (reflection.nDotL <= 0.0) continue;
        const double weight = 2.0 * s * lobe.weight(std::min(reflection.nDotL, 1.0), normals.v.z);
        sum.lobe += weight;
        sum.schlick += weight * fifthPower(std::max(1.0 - reflection.vDotH, 0.0));
    }
    const double scale = (1.0 - start) / heightSamples;
    return {sum.lobe * scale, sum.schlick * scale};
}

/// Over all azimuths. The lobe is mirror-symmetric: half of them suffice.
Integrals integrals(const Lobe& lobe, double nDotV) {
    const glm::dvec3 v(std::sqrt(1.0 - nDotV * nDotV), 0.0, nDotV);
    VisibleNormals normals{v, glm::normalize(glm::dvec3(lobe.alpha * v.x, 0.0, v.z)), lobe.alpha, 0.0};
    Integrals sum;
    for (int i = 0; i < azimuthSamples; ++i) {
        normals.cosAzimuth = std::cos(std::numbers::pi * (i + 0.5) / azimuthSamples);
        const Integrals part = azimuthIntegrals(lobe, normals);
        sum.lobe += part.lobe;
        sum.schlick += part.schlick;
    }
    return {sum.lobe / azimuthSamples, sum.schlick / azimuthSamples};
}

/// The factor of the albedo that is not in the table.
double untabulated(const Lobe& lobe, double nDotV) {
    if (lobe.model == BrdfModel::gltf) return 1.0;
    const double side = schlickSmithSide(nDotV + lobe.alpha, lobe.k);
    return side * side;
}

/// The texel at x: albedo and cosine.
std::array<float, 2> tableTexel(double x, const Lobe& lobe) {
    const double nDotV = std::clamp(x * lobe.alpha / (1.0 + lobe.alpha - x), grazingNDotV, 1.0);
    const Integrals found = integrals(lobe, nDotV);
    const double meanCosine = 1.0 - std::pow(found.schlick / found.lobe, 0.2);
    const bool course = lobe.model == BrdfModel::course;
    const AlbedoBias bias = course ? courseAlbedoBias : gltfAlbedoBias;
    const double albedo = (found.lobe * bias.factor + bias.offset) / untabulated(lobe, nDotV);
    return {static_cast<float>(course ? albedo : std::min(albedo, 1.0)),
            static_cast<float>(meanCosine / (nDotV + lobe.alpha) * bias.cosineFactor)};
}

using AlbedoTable = std::array<float, std::size_t{2} * albedoTableSize * albedoTableSize>;

AlbedoTable computeTable(BrdfModel model) {
    AlbedoTable table{};
    constexpr double last = albedoTableSize - 1;
    ThreadPool::shared()->run(albedoTableSize, [&](std::size_t row, unsigned) {
        const int j = static_cast<int>(row);
        const Lobe lobe(model, j / last);
        for (int i = 0; i < albedoTableSize; ++i) {
            const auto texel = tableTexel(i / last, lobe);
            std::copy(texel.begin(), texel.end(), table.begin() + 2 * (j * albedoTableSize + i));
        }
    });
    return table;
}

/// Bilinear between the four texels around x and y.
std::array<double, 2> readTable(BrdfModel model, double x, double y) {
    constexpr int last = albedoTableSize - 1;
    const int i = std::min(static_cast<int>(x * last), last - 1);
    const int j = std::min(static_cast<int>(y * last), last - 1);
    const float* low = directionalAlbedoTable(model).data() + 2 * (j * albedoTableSize + i);
    const float* high = low + 2 * albedoTableSize;
    std::array<double, 2> value{};
    for (int c = 0; c < 2; ++c) {
        value[static_cast<std::size_t>(c)] =
            glm::mix(glm::mix(double(low[c]), double(low[c + 2]), x * last - i),
                     glm::mix(double(high[c]), double(high[c + 2]), x * last - i), y * last - j);
    }
    return value;
}

}  // namespace

std::span<const float> directionalAlbedoTable(BrdfModel model) {
    if (model == BrdfModel::course) {
        static const AlbedoTable course = computeTable(BrdfModel::course);
        return course;
    }
    static const AlbedoTable gltf = computeTable(BrdfModel::gltf);
    return gltf;
}

LobeAlbedo lobeAlbedo(BrdfModel model, double nDotV, double roughness) {
    nDotV = std::clamp(nDotV, minNDotV, 1.0);
    const Lobe lobe(model, roughness);
    const double reach = nDotV + lobe.alpha;
    const auto [albedo, cosine] = readTable(model, nDotV * (1.0 + lobe.alpha) / reach, roughness);
    return {std::min(albedo * untabulated(lobe, nDotV), 1.0),
            fifthPower(std::max(1.0 - cosine * reach, 0.0))};
}

}  // namespace candela
