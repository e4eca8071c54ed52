// The maps of environments against integration over all texels of their pictures in double precision.

#include "support/skies.h"

#include "render/environment/environment_map.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

namespace candela::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A map at a direction, interpolated as shaders/shared/environment.h does.
glm::dvec3 lookUp(const EnvironmentMap& environment, const OctahedralMap& map, const glm::dvec3& direction) {
    const glm::dvec3 d = direction / (std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
    const double below = std::max(-d.y, 0.0);
    const glm::dvec2 at(d.x + std::copysign(below, d.x), d.z + std::copysign(below, d.z));
    const glm::dvec2 texel = (at * 0.5 + 0.5) * static_cast<double>(map.size - 1);
    const glm::dvec2 low = glm::min(glm::floor(texel), static_cast<double>(map.size - 2)),
                     weight = texel - low;
    const auto fetch = [&](double column, double row) {
        const std::size_t i =
            4 * (map.first + static_cast<std::size_t>(row) * static_cast<std::size_t>(map.size) +
                 static_cast<std::size_t>(column));
        const auto texels = environment.texels();
        return glm::dvec3(texels[i], texels[i + 1], texels[i + 2]);
    };
    return glm::mix(glm::mix(fetch(low.x, low.y), fetch(low.x + 1, low.y), weight.x),
                    glm::mix(fetch(low.x, low.y + 1), fetch(low.x + 1, low.y + 1), weight.x), weight.y);
}

glm::dvec3 irradiance(const EnvironmentMap& environment, const glm::dvec3& normal) {
    glm::dvec3 sum = lookUp(environment, environment.irradiance(), normal);
    for (const EnvironmentPeak& peak : environment.peaks()) {
        const double cosine = glm::dot(normal, glm::dvec3(peak.direction)), half = peak.halfWidth;
        const double above = std::clamp(cosine + half, 0.0, 2.0 * half);
        sum += glm::dvec3(peak.irradiance) * (above * above / (4.0 * half) + std::max(cosine - half, 0.0));
    }
    return sum;
}

glm::dvec3 integratedIrradiance(const std::vector<SkyTexel>& texels, const glm::dvec3& normal) {
    glm::dvec3 sum(0.0);
    for (const SkyTexel& texel : texels)
        sum += texel.radiance * (texel.solidAngle * std::max(glm::dot(normal, texel.direction), 0.0));
    return sum;
}

/// The sky under the lobe of `alpha` around `direction` for n = v = r.
glm::dvec3 integratedLobe(const std::vector<SkyTexel>& texels, const glm::dvec3& direction, double alpha) {
    glm::dvec3 sum(0.0);
    double whole = 0.0;
    for (const SkyTexel& texel : texels) {
        const double cosine = glm::dot(direction, texel.direction);
        if (cosine <= 0.0) continue;
        const double q = alpha * alpha + (1.0 - alpha * alpha) * 0.5 * (1.0 - cosine);
        const double weight = cosine / (q * q) * texel.solidAngle;
        sum += texel.radiance * weight;
        whole += weight;
    }
    return sum / whole;
}

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

TEST(EnvironmentMapTest, irradianceIsThatOfIntegration) {
    std::vector<NamedSky> all = skies(1024);
    all.push_back(hardSun(1024));
    std::vector<glm::dvec3> normals = sphereDirections(400);
    // On the edges of the octahedron, where the map has folds.
    for (const glm::dvec3& edge : {glm::dvec3(0, -1, 1), glm::dvec3(1, -2, 0), glm::dvec3(0, 1, -3),
                                   glm::dvec3(-2, 0, 1), glm::dvec3(0, -1, 0)})
        normals.push_back(glm::normalize(edge));
    for (const NamedSky& sky : all) {
        const EnvironmentMap environment(sky.picture, glm::dmat3(1.0));
        const std::vector<SkyTexel> texels = texelsOf(sky.picture);
        double worst = 0.0;
        for (const glm::dvec3& normal : normals) {
            const glm::dvec3 expected = integratedIrradiance(texels, normal);
            worst = std::max(worst, largest((irradiance(environment, normal) - expected) / expected));
        }
        std::printf("%-12s %zu peaks, largest error of irradiance %.4f\n", sky.name.c_str(),
                    environment.peaks().size(), worst);
        // The interpolation between texels, and cells on the horizon of a normal, of which a part counts.
        // Soft boxes of 400 times the floor's radiance that are about to rise count most.
        EXPECT_LT(worst, sky.name == "soft boxes" ? 0.01 : 0.003) << sky.name;
    }
}

TEST(EnvironmentMapTest, levelsAreThoseOfIntegration) {
    for (const NamedSky& sky : skies(1024)) {
        const EnvironmentMap environment(sky.picture, glm::dmat3(1.0));
        const std::vector<SkyTexel> texels = texelsOf(sky.picture);
        // Lobes of the last two levels are narrower than some texels of the picture, which are points here.
        for (int level = 0; level < EnvironmentMap::levelCount - 3; ++level) {
            double worst = 0.0, sum = 0.0;
            const auto directions = sphereDirections(12);
            for (const glm::dvec3& direction : directions) {
                const glm::dvec3 expected = integratedLobe(texels, direction, std::exp2(-level));
                const double off =
                    largest((lookUp(environment, environment.level(level), direction) - expected) / expected);
                worst = std::max(worst, off), sum += off;
            }
            const double mean = sum / static_cast<double>(directions.size());
            std::printf("%-12s level %d: mean error %.4f, largest %.4f\n", sky.name.c_str(), level, mean,
                        worst);
            // The interpolation between texels, and cells read as points.
            EXPECT_LT(mean, sky.name == "constant" ? 1.0e-5 : 0.05) << sky.name << ", level " << level;
        }
    }
}

TEST(EnvironmentMapTest, allKernelsAgree) {
    const Image sky = skies(256)[2].picture;
    const EnvironmentMap reference(sky, glm::dmat3(1.0), *environmentKernels().back());
    for (const EnvironmentKernel* kernel : environmentKernels()) {
        const EnvironmentMap environment(sky, glm::dmat3(1.0), *kernel);
        ASSERT_EQ(environment.texels().size(), reference.texels().size());
        double worst = 0.0;
        for (std::size_t i = 0; i < reference.texels().size(); ++i) {
            const double expected = reference.texels()[i];
            worst =
                std::max(worst, std::abs(environment.texels()[i] - expected) / (1.0 + std::abs(expected)));
        }
        // Sums of some hundred products in single precision; a cell at the limit may be read whole or in
        // parts.
        EXPECT_LT(worst, 1.0e-2) << kernel->name;
        std::printf("kernel %s: largest difference %.1e\n", kernel->name, worst);
    }
}

TEST(EnvironmentMapTest, smallPicturesAreInterpolated) {
    const Image one = makeSky(2, [](const glm::dvec3&) { return glm::vec3(0.5f, 2.0f, 3.0f); });
    const EnvironmentMap environment(one, glm::dmat3(2.0));
    for (const glm::dvec3& direction : sphereDirections(20)) {
        for (int level = 0; level < EnvironmentMap::levelCount; ++level)
            EXPECT_LT(
                largest(lookUp(environment, environment.level(level), direction) - glm::dvec3(1.0, 4.0, 6.0)),
                1.0e-4);
        EXPECT_LT(largest(irradiance(environment, direction) - pi * glm::dvec3(1.0, 4.0, 6.0)), 1.0e-4);
    }
}

}  // namespace
}  // namespace candela::test
