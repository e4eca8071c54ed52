#include "shading/sheen_albedo.h"

#include "base/thread_pool.h"
#include "shading/argument_checks.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace candela {

using namespace arguments;

namespace {

using Scalar = double;
#include "shared/shading_constants.h"

constexpr int samples = 32;
constexpr double last = albedoTableSize - 1;

/// Over one hemisphere of lights, of which n·l is the square of an even sequence: the lobe is steepest where
/// both directions graze. It is mirror-symmetric, so that half of the azimuths suffice.
double integratedAlbedo(double nDotV, double roughness) {
    const double halfExponent = 0.5 / (roughness * roughness);
    const double sineV = std::sqrt(1.0 - nDotV * nDotV);
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        const double s = (i + 0.5) / samples, nDotL = s * s, sineL = std::sqrt(1.0 - nDotL * nDotL);
        double row = 0.0;
        for (int j = 0; j < samples; ++j) {
            const double cosAzimuth = std::cos(std::numbers::pi * (j + 0.5) / samples);
            const double tangential2 = sineL * sineL + sineV * sineV + 2.0 * sineL * sineV * cosAzimuth;
            const double normal2 = (nDotL + nDotV) * (nDotL + nDotV);
            row += std::exp(halfExponent * std::log(tangential2 / (tangential2 + normal2)));
        }
        sum += row * visibilityNeubelt(nDotL, nDotV) * nDotL * 2.0 * s;
    }
    // D's factor is (2 + 2 halfExponent) / 2 pi, and azimuths span 2 pi.
    return sum / (samples * samples) * (2.0 + 2.0 * halfExponent);
}

using Table = std::array<float, std::size_t{2} * albedoTableSize * albedoTableSize>;

Table computeTable() {
    Table table{};
    ThreadPool::shared()->run(albedoTableSize, [&](std::size_t row, unsigned) {
        const int j = static_cast<int>(row);
        const double roughness = MIN_SHEEN_ROUGHNESS + (1.0 - MIN_SHEEN_ROUGHNESS) * j / last;
        for (int i = 0; i < albedoTableSize; ++i) {
            const double nDotV = std::max(i / last * (i / last), minNDotV);
            table[static_cast<std::size_t>(2 * (j * albedoTableSize + i))] =
                static_cast<float>(integratedAlbedo(nDotV, roughness) * sheenAlbedoBias);
        }
    });
    return table;
}

}  // namespace

std::span<const float> sheenAlbedoTable() {
    static const Table table = computeTable();
    return table;
}

double distributionCharlie(double nDotH, double roughness) {
    requireCosine(nDotH, "n·h");
    requireUnitRange(roughness, "roughness");
    const double inverseAlpha = 1.0 / std::pow(std::max(roughness, MIN_SHEEN_ROUGHNESS), 2.0);
    const double sine = std::sqrt(std::max(1.0 - nDotH * nDotH, 0.0));
    return (2.0 + inverseAlpha) * std::pow(sine, inverseAlpha) / (2.0 * std::numbers::pi);
}

double visibilityNeubelt(double nDotL, double nDotV) {
    requireCosine(nDotL, "n·l");
    requireCosine(nDotV, "n·v");
    return 1.0 / (4.0 * (nDotL + nDotV - nDotL * nDotV));
}

double sheenAlbedo(double nDotV, double roughness) {
    requireCosine(nDotV, "n·v");
    requireUnitRange(roughness, "roughness");
    const double x = std::sqrt(std::clamp(nDotV, minNDotV, 1.0)) * last;
    const double y =
        (std::max(roughness, MIN_SHEEN_ROUGHNESS) - MIN_SHEEN_ROUGHNESS) / (1.0 - MIN_SHEEN_ROUGHNESS) * last;
    const int i = std::min(static_cast<int>(x), albedoTableSize - 2);
    const int j = std::min(static_cast<int>(y), albedoTableSize - 2);
    const float* low = sheenAlbedoTable().data() + 2 * (j * albedoTableSize + i);
    const float* high = low + 2 * albedoTableSize;
    return glm::mix(glm::mix(double(low[0]), double(low[2]), x - i),
                    glm::mix(double(high[0]), double(high[2]), x - i), y - j);
}

}  // namespace candela
