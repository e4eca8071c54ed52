// Surfaces with more lobes: the textbook form of candela/brdf.h against integrals, and the merged form of
// shaders/shared/extended_lobes.h against the textbook form.

#include "merged_form.h"

#include "furnace.h"
#include "shading/sheen_albedo.h"

#include <candela/error.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <random>

namespace candela {
namespace {

constexpr BrdfModel models[] = {BrdfModel::course, BrdfModel::gltf};

struct Random {
    std::mt19937 engine{17};
    double operator()(double low = 0.0, double high = 1.0) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
    /// Half of the time one of the ends.
    double strength() {
        const double kind = (*this)();
        return kind < 0.25 ? 0.0 : kind < 0.5 ? 1.0 : (*this)();
    }
    glm::dvec3 color() { return {(*this)(), (*this)(), (*this)()}; }
    glm::dvec3 direction() {
        std::normal_distribution<double> normal;
        return glm::normalize(glm::dvec3(normal(engine), normal(engine), normal(engine)));
    }
    glm::dvec3 perpendicular(const glm::dvec3& n) { return glm::normalize(glm::cross(n, direction())); }
};

/// Any lobes, with normal n. White surfaces return the most.
SurfacePoint randomSurface(Random& random, const glm::dvec3& n, double minRoughness) {
    const auto color = [&] { return random() < 0.5 ? glm::dvec3(1.0) : random.color(); };
    SurfacePoint surface;
    surface.normal = n;
    surface.lobes = {color(), random.strength(), random(minRoughness, 1.0)};
    ExtendedLobes<double> lobes;
    lobes.f0 = random() < 0.3 ? glm::dvec3(1.0) : random.color() * random();
    lobes.f90 = random.strength();
    lobes.anisotropy = random.strength();
    lobes.anisotropyDirection = random.perpendicular(n);
    lobes.sheenColor = random() < 0.5 ? glm::dvec3(0.0) : color();
    lobes.sheenRoughness = random();
    lobes.clearcoat = random.strength();
    lobes.clearcoatRoughness = random(minRoughness, 1.0);
    lobes.clearcoatNormal = random() < 0.5 ? n : glm::normalize(n + 0.3 * random() * random.perpendicular(n));
    lobes.transmission = random() < 0.7 ? 0.0 : random();
    lobes.diffuseTransmission = random.strength();
    lobes.diffuseTransmissionColor = color();
    surface.extended = lobes;
    return surface;
}

exact::ExtendedPoint mergedPoint(int brdf, const SurfacePoint& surface, const glm::dvec3& v) {
    const ExtendedLobes<double>& lobes = *surface.extended;
    const exact::ExtendedLobes extended{lobes.f0,
                                        lobes.f90,
                                        lobes.anisotropy,
                                        lobes.anisotropyDirection,
                                        lobes.sheenColor,
                                        lobes.sheenRoughness,
                                        lobes.clearcoat,
                                        lobes.clearcoatRoughness,
                                        lobes.clearcoatNormal,
                                        lobes.transmission,
                                        lobes.diffuseTransmission,
                                        lobes.diffuseTransmissionColor};
    return exact::extendedPoint(brdf,
                                {surface.lobes.baseColor, surface.lobes.metallic, surface.lobes.roughness},
                                extended, surface.normal, glm::dvec3(0.0), v,
                                directionalAlbedoTable(static_cast<BrdfModel>(brdf)), sheenAlbedoTable());
}

/// What a surface returns towards v of light that comes equally from everywhere, both sides. Lights are
/// reflections about normals visible to the specular lobe, about those of the coat, and of the cosine, on
/// either side: the density of each is a third of the sum.
class Furnace {
  public:
    explicit Furnace(const SurfacePoint& surface, const glm::dvec3& v)
        : surface_(surface), v_(v), base_(specularOf(surface)), coat_(coatOf(surface, v)) {}

    double returned(BrdfModel model, int samples) const {
        glm::dvec3 sum(0.0);
        for (int i = 0; i < samples; ++i) {
            for (int j = 0; j < samples; ++j) {
                const double s = (i + 0.5) / samples, azimuth = 2.0 * std::numbers::pi * (j + 0.5) / samples;
                for (const Lobe& lobe : {base_, coat_})
                    sum += contribution(model, reflected(lobe, s, azimuth));
                sum += contribution(model, scattered(s, azimuth));
            }
        }
        sum /= double(samples) * samples;
        return std::max({sum.x, sum.y, sum.z});
    }

  private:
    struct Lobe {
        glm::dvec3 t, b, n;
        double tangentAlpha, bitangentAlpha;

        glm::dvec3 local(const glm::dvec3& w) const {
            return {glm::dot(w, t), glm::dot(w, b), glm::dot(w, n)};
        }
    };

    static double alphaOf(double roughness) { return std::max(roughness * roughness, minAlpha); }
    static Lobe specularOf(const SurfacePoint& surface) {
        const ExtendedLobes<double>& lobes = *surface.extended;
        const double alpha = alphaOf(surface.lobes.roughness);
        return {lobes.anisotropyDirection, glm::cross(surface.normal, lobes.anisotropyDirection),
                surface.normal, glm::mix(alpha, 1.0, lobes.anisotropy * lobes.anisotropy), alpha};
    }
    /// Where its normal points away from v, the one that is perpendicular to v.
    static Lobe coatOf(const SurfacePoint& surface, const glm::dvec3& v) {
        const glm::dvec3& own = surface.extended->clearcoatNormal;
        const glm::dvec3 n = glm::normalize(own - v * std::min(glm::dot(own, v), 0.0));
        const glm::dvec3 t =
            glm::normalize(glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
        const double alpha = alphaOf(surface.extended->clearcoatRoughness);
        return {t, glm::cross(n, t), n, alpha, alpha};
    }
    /// v in the frame of a lobe, not below its horizon.
    glm::dvec3 seenFrom(const Lobe& lobe) const {
        const glm::dvec3 v = lobe.local(v_);
        return glm::normalize(glm::dvec3(v.x, v.y, std::max(v.z, 1.0e-3)));
    }
    glm::dvec3 reflected(const Lobe& lobe, double s, double azimuth) const {
        const glm::dvec3 v = seenFrom(lobe), alphas(lobe.tangentAlpha, lobe.bitangentAlpha, 1.0);
        const glm::dvec3 stretched = glm::normalize(alphas * v);
        const double z = s * (1.0 + stretched.z) - stretched.z;
        const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
        const glm::dvec3 h = glm::normalize(
            alphas * (stretched + glm::dvec3(radius * std::cos(azimuth), radius * std::sin(azimuth), z)));
        const glm::dvec3 l = 2.0 * glm::dot(v, h) * h - v;
        return lobe.t * l.x + lobe.b * l.y + lobe.n * l.z;
    }
    /// Of lights, in 1/sr.
    double density(const Lobe& lobe, const glm::dvec3& l) const {
        const glm::dvec3 v = seenFrom(lobe), alphas(lobe.tangentAlpha, lobe.bitangentAlpha, 1.0);
        const glm::dvec3 h = glm::normalize(lobe.local(l) + v);
        if (h.z <= 0.0 || glm::dot(h, v) <= 0.0) return 0.0;
        const double masking = 2.0 / (1.0 + glm::length(alphas * v) / v.z);
        return distributionGgxAnisotropic(h, lobe.tangentAlpha, lobe.bitangentAlpha) * masking / (4.0 * v.z);
    }
    /// Over the whole sphere, by the cosine.
    glm::dvec3 scattered(double s, double azimuth) const {
        const double side = s < 0.5 ? -1.0 : 1.0, area = s < 0.5 ? 2.0 * s : 2.0 * s - 1.0;
        const double radius = std::sqrt(area);
        return base_.t * (radius * std::cos(azimuth)) + base_.b * (radius * std::sin(azimuth)) +
               base_.n * (side * std::sqrt(1.0 - area));
    }
    glm::dvec3 contribution(BrdfModel model, const glm::dvec3& l) const {
        const double sum =
            density(base_, l) + density(coat_, l) + std::abs(glm::dot(base_.n, l)) / (2.0 * std::numbers::pi);
        return sum > 0.0 ? evaluateReflection(model, surface_, l, v_) / sum : glm::dvec3(0.0);
    }

    SurfacePoint surface_;
    glm::dvec3 v_;
    Lobe base_, coat_;
};

glm::dvec3 randomView(Random& random, const glm::dvec3& n) {
    const double cosine = std::max(std::pow(random(), 2.0), 0.003);
    return n * cosine + random.perpendicular(n) * std::sqrt(1.0 - cosine * cosine);
}

/// Of 40² lights a lobe: over 1,500 surfaces it is at most 5e-3 where four times as many give 1 or less.
constexpr double quadratureError = 6.0e-3;

TEST(ExtendedFurnace, noStackOfLobesReturnsMoreThanItReceives) {
    Random random;
    for (const BrdfModel model : models) {
        double highest = 0.0;
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 n = random.direction();
            const SurfacePoint surface = randomSurface(random, n, 0.05);
            const glm::dvec3 v = randomView(random, n);
            const double returned = Furnace(surface, v).returned(model, 40);
            EXPECT_LE(returned, 1.0 + quadratureError) << toString(model) << " surface " << i;
            highest = std::max(highest, returned);
        }
        std::printf("%s: at most %.4f\n", toString(model), highest);
    }
}

// A mirror-like coat whose normal is up to 90 degrees off, seen at grazing angles: from behind its own
// normal.
TEST(ExtendedFurnace, aCoatSeenFromBehindItsNormalReturnsNoMore) {
    Random random;
    for (const BrdfModel model : models) {
        double highest = 0.0;
        int seenFromBehind = 0;
        for (int i = 0; i < 60; ++i) {
            const glm::dvec3 n = random.direction(), v = randomView(random, n);
            SurfacePoint surface = randomSurface(random, n, 0.05);
            ExtendedLobes<double>& lobes = *surface.extended;
            lobes.clearcoat = 1.0;
            lobes.sheenColor = glm::dvec3(0.0);
            lobes.clearcoatNormal = glm::normalize(n - random(0.5, 3.0) * v);
            if (glm::dot(lobes.clearcoatNormal, v) < 0.0) ++seenFromBehind;
            const double returned = Furnace(surface, v).returned(model, 40);
            EXPECT_LE(returned, 1.0 + quadratureError) << toString(model) << " surface " << i;
            highest = std::max(highest, returned);
        }
        EXPECT_GT(seenFromBehind, 30);
        std::printf("%s: at most %.4f\n", toString(model), highest);
    }
}

// The albedo that compensation divides by is 3 % too high, and its mean over 64 reflections another 2 % at
// most.
TEST(ExtendedFurnace, anisotropicMetalLosesATwentiethAtMost) {
    Random random;
    double lowest = 1.0;
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 n = random.direction(), v = randomView(random, n);
        SurfacePoint surface = randomSurface(random, n, 0.05);
        surface.lobes.metallic = 1.0;
        ExtendedLobes<double> lobes;
        lobes.f0 = glm::dvec3(1.0);
        lobes.f90 = 1.0;
        lobes.anisotropy = random(0.1, 1.0);
        lobes.anisotropyDirection = random.perpendicular(n);
        lobes.clearcoatNormal = n;
        surface.extended = lobes;
        const double returned = Furnace(surface, v).returned(BrdfModel::gltf, 60);
        EXPECT_GE(returned, 0.95 - quadratureError) << "surface " << i;
        EXPECT_LE(returned, 1.0 + quadratureError) << "surface " << i;
        lowest = std::min(lowest, returned);
    }
    std::printf("at least %.4f\n", lowest);
}

TEST(ExtendedMerged, isTheTextbookForm) {
    Random random;
    for (const BrdfModel model : models) {
        const int brdf = static_cast<int>(model);
        for (int i = 0; i < 3000; ++i) {
            const glm::dvec3 n = random.direction();
            const SurfacePoint surface = randomSurface(random, n, 0.1);
            const glm::dvec3 v = randomView(random, n), l = random.direction();
            const exact::ExtendedPoint point = mergedPoint(brdf, surface, v);
            const glm::dvec3 merged = exact::extendedReflection(brdf, point, l);
            const glm::dvec3 textbook = evaluateReflection(model, surface, l, v);
            // The sample points of the albedo of two alphas have eight digits in shaders.
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(merged[c], textbook[c], 1.0e-5 * textbook[c] + 1.0e-9) << "surface " << i;
            const ExtendedLobes<double>& lobes = *surface.extended;
            EXPECT_TRUE(textbook == glm::dvec3(0.0) ||
                        exact::facingOfLobes(n, lobes.clearcoat,
                                             exact::seenCoatNormal(lobes.clearcoatNormal, v),
                                             lobes.diffuseTransmission, l) > 0.0);
        }
    }
}

TEST(ExtendedMerged, withoutFurtherLobesItIsThePlainSurface) {
    Random random;
    for (const BrdfModel model : models) {
        for (int i = 0; i < 300; ++i) {
            SurfacePoint surface;
            surface.normal = random.direction();
            surface.lobes = {random.color(), random.strength(), random(0.1, 1.0)};
            const glm::dvec3 v = randomView(random, surface.normal), l = random.direction();
            const glm::dvec3 plain = evaluateReflection(model, surface, l, v);
            ExtendedLobes<double> lobes;
            lobes.f0 = glm::mix(glm::dvec3(0.04), surface.lobes.baseColor, surface.lobes.metallic);
            lobes.anisotropyDirection = random.perpendicular(surface.normal);
            lobes.clearcoatNormal = surface.normal;
            surface.extended = lobes;
            const glm::dvec3 extended = evaluateReflection(model, surface, l, v);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(extended[c], plain[c], 1.0e-9 * plain[c] + 1.0e-12);
        }
    }
}

/// By the midpoint rule with lights dense at the horizon.
double integratedSheen(double nDotV, double roughness, int samples) {
    const glm::dvec3 v = furnace::viewDirection(nDotV);
    return furnace::mean(samples, [&](double azimuth, double s) {
        const double nDotL = s * s, sine = std::sqrt(1.0 - nDotL * nDotL);
        const glm::dvec3 l(sine * std::cos(azimuth), sine * std::sin(azimuth), nDotL);
        const double lobe = distributionCharlie(glm::normalize(l + v).z, roughness);
        return lobe * visibilityNeubelt(nDotL, nDotV) * nDotL * 2.0 * s * 2.0 * std::numbers::pi;
    });
}

TEST(Sheen, albedoIsJustAboveTheIntegral) {
    for (const double roughness : {0.07, 0.09, 0.12, 0.2, 0.31, 0.5, 0.77, 1.0}) {
        for (const double nDotV : {1.0e-4, 0.005, 0.02, 0.05, 0.09, 0.15, 0.3, 0.45, 0.7, 1.0}) {
            const double integral = integratedSheen(nDotV, roughness, 160);
            const double table = sheenAlbedo(nDotV, roughness);
            EXPECT_GE(table, integral * 0.999 - 1.0e-4) << roughness << " n·v " << nDotV;
            // The bias, and the interpolation where the lobe of smooth cloth falls off.
            EXPECT_LE(table, integral * 1.06 + 6.0e-3) << roughness << " n·v " << nDotV;
        }
    }
}

TEST(Sheen, theDistributionIsNormalised) {
    for (const double roughness : {0.07, 0.3, 1.0}) {
        double sum = 0.0;
        constexpr int count = 20000;
        for (int i = 0; i < count; ++i) {
            const double cosine = std::pow((i + 0.5) / count, 2.0);
            sum += distributionCharlie(cosine, roughness) * cosine * std::sqrt(cosine);
        }
        EXPECT_NEAR(sum * 4.0 * std::numbers::pi / count, 1.0, 1.0e-4);
    }
}

TEST(ExtendedBrdf, checksItsArguments) {
    const glm::dvec3 up(0.0, 0.0, 1.0);
    const auto with = [&](auto member, auto value) {
        SurfacePoint surface;
        surface.extended.emplace();
        (*surface.extended).*member = value;
        return surface;
    };
    using Lobes = ExtendedLobes<double>;
    EXPECT_NO_THROW(evaluateReflection(BrdfModel::gltf, with(&Lobes::clearcoat, 1.0), up, up));
    for (const double value : {-0.1, 1.1, std::nan("")}) {
        for (double Lobes::*member :
             {&Lobes::f90, &Lobes::anisotropy, &Lobes::sheenRoughness, &Lobes::clearcoat,
              &Lobes::clearcoatRoughness, &Lobes::transmission, &Lobes::diffuseTransmission}) {
            EXPECT_THROW(evaluateReflection(BrdfModel::gltf, with(member, value), up, up), Error);
        }
        for (glm::dvec3 Lobes::*member : {&Lobes::f0, &Lobes::sheenColor, &Lobes::diffuseTransmissionColor})
            EXPECT_THROW(evaluateReflection(BrdfModel::gltf, with(member, glm::dvec3(value)), up, up), Error);
    }
    const glm::dvec3 longer(0.0, 0.0, 2.0);
    EXPECT_THROW(evaluateReflection(BrdfModel::gltf, with(&Lobes::clearcoatNormal, longer), up, up), Error);
    EXPECT_THROW(evaluateReflection(BrdfModel::gltf, with(&Lobes::anisotropyDirection, up), up, up), Error);
    EXPECT_THROW(sheenAlbedo(2.0, 0.5), Error);
    EXPECT_THROW(distributionCharlie(0.5, 1.5), Error);
    EXPECT_THROW(visibilityNeubelt(0.5, 1.5), Error);
}

}  // namespace
}  // namespace candela
