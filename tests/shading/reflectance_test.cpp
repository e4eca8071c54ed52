#include <candela/brdf.h>

#include <candela/error.h>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

// F0 of dielectrics and thin films: shaders/shared/reflectance.h against the double-precision form.

namespace candela {
namespace {

namespace single {

using namespace glm;

#define SHARED_FUNCTION inline
#include "shared/reflectance.h"
#undef SHARED_FUNCTION

}  // namespace single

double largest(const glm::dvec3& difference) {
    return std::max({std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)});
}

struct Random {
    std::mt19937 engine{7};
    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
    glm::dvec3 color() { return {(*this)(0.0, 1.0), (*this)(0.0, 1.0), (*this)(0.0, 1.0)}; }
};

TEST(DielectricF0, FollowsIndexAndSpecularFactors) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_NEAR(dielectricF0(1.5, 1.0, glm::dvec3(1.0)).x, 0.04, 1e-12);
    EXPECT_NEAR(dielectricF0(1.0, 1.0, glm::dvec3(1.0)).x, 0.0, 1e-12);
    EXPECT_EQ(dielectricF0(infinity, 0.5, glm::dvec3(0.2, 1.0, 7.0)), glm::dvec3(0.1, 0.5, 0.5));
    // The colour may raise F0 to 1, and not beyond; the factor applies after that.
    EXPECT_NEAR(dielectricF0(1.5, 0.5, glm::dvec3(100.0)).x, 0.5, 1e-12);
    EXPECT_THROW(dielectricF0(0.9, 1.0, glm::dvec3(1.0)), Error);
    EXPECT_THROW(dielectricF0(1.5, 1.1, glm::dvec3(1.0)), Error);
    EXPECT_THROW(dielectricF0(1.5, 1.0, glm::dvec3(-1.0)), Error);
}

TEST(DielectricF0, IsTheSameInShaders) {
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const double ior = i == 0 ? std::numeric_limits<double>::infinity() : random(1.0, 3.0);
        const double specular = random(0.0, 1.0);
        const glm::dvec3 color = random.color() * 10.0;
        const glm::dvec3 exact = dielectricF0(ior, specular, color);
        const glm::dvec3 found(single::dielectricF0(float(ior), float(specular), glm::vec3(color)));
        EXPECT_LE(largest(found - exact), 1e-6) << ior;
    }
}

TEST(IridescentF0, NoFilmLeavesTheBase) {
    for (const double nDotV : {0.2, 0.5, 1.0}) {
        const glm::dvec3 base(0.04, 0.5, 0.9);
        // Of a film without thickness, and of one that is air: Schlick's term there and back.
        EXPECT_LE(largest(iridescentF0(nDotV, base, 1.3, 0.0) - base), 1e-9);
        EXPECT_LE(largest(iridescentF0(nDotV, base, 1.0, 300.0) - base), 1e-9);
    }
}

/// The reflectance of a film at normal incidence for one wavelength, by Airy's sum.
double airy(double filmIor, double baseIor, double nanometres, double wavelength) {
    const double r12 = (1.0 - filmIor) / (1.0 + filmIor), r23 = (filmIor - baseIor) / (filmIor + baseIor);
    const double phase = 4.0 * 3.14159265358979 * filmIor * nanometres / wavelength;
    const double both = 2.0 * r12 * r23 * std::cos(phase);
    return (r12 * r12 + r23 * r23 + both) / (1.0 + r12 * r12 * r23 * r23 + both);
}

// The colour matching functions are fitted for the eye and not for one wavelength, so that the comparison is
// with a mean of wavelengths around green, and by direction: where Airy's sum is bright, so is the film.
TEST(IridescentF0, InterferesAsAirySays) {
    for (double nanometres = 100.0; nanometres <= 400.0; nanometres += 50.0) {
        double mean = 0.0;
        for (int i = -4; i <= 4; ++i) mean += airy(1.4, 1.9, nanometres, 550.0 + 10.0 * i) / 9.0;
        const double base = std::pow(0.9 / 2.9, 2.0);
        const double film = iridescentF0(1.0, glm::dvec3(base), 1.4, nanometres).y;
        EXPECT_NEAR(film, mean, 0.03) << nanometres << " nm";
    }
}

TEST(IridescentF0, IsTheSameInShaders) {
    Random random;
    double worst = 0.0;
    for (int i = 0; i < 5000; ++i) {
        const double nDotV = random(0.05, 1.0), ior = random(1.0, 2.5), nanometres = random(0.0, 1500.0);
        const glm::dvec3 base = random.color();
        const glm::dvec3 exact = iridescentF0(nDotV, base, ior, nanometres);
        const glm::dvec3 found(
            single::iridescentF0(float(nDotV), glm::vec3(base), float(ior), float(nanometres)));
        // Schlick's inversion divides by the angle's weight; a channel whose base has the film's own index
        // jumps, as its reflection is of one sign or the other, by what reflects there: nothing.
        const double weight = 1.0 - std::pow(1.0 - nDotV, 5.0);
        worst = std::max(worst, largest(found - exact) * weight);
        EXPECT_GE(std::min({found.x, found.y, found.z}), 0.0);
        EXPECT_LE(std::max({found.x, found.y, found.z}), 1.0);
    }
    std::printf("iridescent F0: float differs by up to %.2g\n", worst);
    EXPECT_LE(worst, 2e-3);
}

TEST(IridescentF0, ChecksItsArguments) {
    EXPECT_THROW(iridescentF0(1.5, glm::dvec3(0.04), 1.3, 100.0), Error);
    EXPECT_THROW(iridescentF0(1.0, glm::dvec3(1.04), 1.3, 100.0), Error);
    EXPECT_THROW(iridescentF0(1.0, glm::dvec3(0.04), 0.9, 100.0), Error);
    EXPECT_THROW(iridescentF0(1.0, glm::dvec3(0.04), 1.3, -1.0), Error);
}

}  // namespace
}  // namespace candela
