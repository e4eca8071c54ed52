// The maps of environments against integration over all texels of their pictures in double precision.

#include "support/skies.h"

#include "render/environment/environment_map.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <chrono>
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
    const glm::dvec2 texel = (at * 0.5 + 0.5) * static_cast<double>(map.size) + 0.5;
    const glm::dvec2 low = glm::floor(texel), weight = texel - low;
    const auto fetch = [&](double column, double row) {
        const std::size_t i =
            4 * (map.first + static_cast<std::size_t>(row) * static_cast<std::size_t>(map.size + 2) +
                 static_cast<std::size_t>(column));
        const auto texels = environment.texels();
        return glm::dvec3(texels[i], texels[i + 1], texels[i + 2]);
    };
    return glm::mix(glm::mix(fetch(low.x, low.y), fetch(low.x + 1, low.y), weight.x),
                    glm::mix(fetch(low.x, low.y + 1), fetch(low.x + 1, low.y + 1), weight.x), weight.y);
}

glm::dvec3 irradiance(const EnvironmentMap& environment, const glm::dvec3& normal) {
    glm::dvec3 sum = lookUp(environment, environment.irradiance(), normal);
    for (const EnvironmentPeak& peak : environment.peaks())
        sum += glm::dvec3(peak.irradiance) * std::max(glm::dot(normal, glm::dvec3(peak.direction)), 0.0);
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

class EnvironmentMapTest : public testing::Test {
  protected:
    static std::vector<NamedSky> allSkies() {
        std::vector<NamedSky> all = skies(2048);
        all.push_back(hardSun(2048));
        return all;
    }
};

TEST_F(EnvironmentMapTest, irradianceIsThatOfIntegration) {
    for (const NamedSky& sky : allSkies()) {
        const auto begin = std::chrono::steady_clock::now();
        const EnvironmentMap environment(sky.picture, glm::dmat3(1.0));
        const double ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        const std::vector<SkyTexel> texels = texelsOf(sky.picture);
        double worst = 0.0;
        for (const glm::dvec3& normal : sphereDirections(200)) {
            const glm::dvec3 expected = integratedIrradiance(texels, normal);
            worst = std::max(worst, largest((irradiance(environment, normal) - expected) / expected));
        }
        std::printf("%-12s %7.1f ms, peaks %zu: worst irradiance %.4f\n", sky.name.c_str(), ms,
                    environment.peaks().size(), worst);
        EXPECT_LT(worst, 0.01) << sky.name;
    }
}

TEST_F(EnvironmentMapTest, levelsAreThoseOfIntegration) {
    for (const NamedSky& sky : allSkies()) {
        const EnvironmentMap environment(sky.picture, glm::dmat3(1.0));
        const std::vector<SkyTexel> texels = texelsOf(sky.picture);
        for (int level = 0; level < EnvironmentMap::levelCount - 1; ++level) {
            double worst = 0.0, sum = 0.0;
            const auto directions = sphereDirections(60);
            for (const glm::dvec3& direction : directions) {
                const glm::dvec3 expected = integratedLobe(texels, direction, std::exp2(-level));
                const double off =
                    largest((lookUp(environment, environment.level(level), direction) - expected) / expected);
                worst = std::max(worst, off), sum += off;
            }
            std::printf("%-12s level %d: worst %.4f mean %.5f\n", sky.name.c_str(), level, worst,
                        sum / static_cast<double>(directions.size()));
        }
    }
}

}  // namespace
}  // namespace candela::test
