#include "furnace.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>

#include <cstdio>
#include <vector>

/// White furnace: a surface under uniform light from all directions. The values here are those of
/// docs/lighting.md.
namespace candela {
namespace {

constexpr BrdfModel models[] = {BrdfModel::course, BrdfModel::gltf};

const double angles[] = {minNDotV, 3.0e-4, 1.0e-3, 3.0e-3, 0.01, 0.03, 0.1, 0.18, 0.3, 0.5, 0.75, 1.0};

/// Samples along each axis of the quadrature, and what is left of its error: that of a third of the samples,
/// measured by the test below, is at most 6e-4, and the midpoint rule's falls at least in proportion.
constexpr int samples = 192;
constexpr double quadratureError = 2.0e-4;

struct Extremes {
    double min = 1.0e9, max = -1.0e9;
    double maxRoughness = 0.0, maxNDotV = 0.0;
};

template <typename Albedo>
Extremes extremes(const Albedo& albedo) {
    Extremes result;
    for (int i = 0; i <= 10; ++i)
        for (double nDotV : angles) {
            const double roughness = i / 10.0, value = albedo(roughness, nDotV);
            result.min = std::min(result.min, value);
            if (value <= result.max) continue;
            result.max = value;
            result.maxRoughness = roughness;
            result.maxNDotV = nDotV;
        }
    return result;
}

TEST(BrdfFurnace, theQuadratureHasConverged) {
    for (BrdfModel model : models)
        for (double roughness : {0.0, 0.1, 0.4, 0.7, 1.0})
            for (double nDotV : angles) {
                const double fine = furnace::whiteMetal(model, roughness, nDotV, samples);
                EXPECT_NEAR(furnace::whiteMetal(model, roughness, nDotV, samples / 3), fine,
                            3.0 * quadratureError)
                    << toString(model) << " roughness " << roughness << " n·v " << nDotV;
                const double both = furnace::whiteDielectric(model, roughness, nDotV, samples);
                EXPECT_NEAR(furnace::whiteDielectric(model, roughness, nDotV, samples / 3), both,
                            3.0 * quadratureError);
            }
}

TEST(BrdfFurnace, aWhiteMetalReturnsNoMoreThanItReceives) {
    for (BrdfModel model : models) {
        const Extremes found =
            extremes([&](double r, double v) { return furnace::whiteMetal(model, r, v, samples); });
        EXPECT_LE(found.max, 1.0 + quadratureError)
            << toString(model) << " roughness " << found.maxRoughness << " n·v " << found.maxNDotV;
    }
}

// What the compensation leaves is the table's bias (1.5e-3 of an E of 0.31 or more) and its interpolation.
TEST(BrdfFurnace, aWhiteMetalOfTheGltfModelLosesLessThanOnePercent) {
    const Extremes found =
        extremes([&](double r, double v) { return furnace::whiteMetal(BrdfModel::gltf, r, v, samples); });
    EXPECT_GE(found.min, 0.99);
}

// The diffuse part takes what the lobe leaves by the table, which is at most 5e-3 above the integral.
TEST(BrdfFurnace, aWhiteDielectricReturnsAllThatItReceives) {
    for (BrdfModel model : models) {
        const Extremes found =
            extremes([&](double r, double v) { return furnace::whiteDielectric(model, r, v, samples); });
        EXPECT_LE(found.max, 1.0 + quadratureError)
            << toString(model) << " roughness " << found.maxRoughness << " n·v " << found.maxNDotV;
        EXPECT_GE(found.min, 0.99) << toString(model);
    }
}

/// What a surface returns, for all colours of one roughness and angle. The lobe of any F0 is F0 a + b times
/// the compensation, so that two integrals suffice.
class Returned {
  public:
    Returned(BrdfModel model, double roughness, double nDotV, int count)
        : model_(model), roughness_(roughness), nDotV_(nDotV) {
        b_ = furnace::specularAlbedo(model, 0.0, roughness, nDotV, count);
        a_ = furnace::whiteMetal(model, roughness, nDotV, count) / compensation(1.0) - b_;
    }

    double operator()(double color, double metallic) const {
        const double f0 = glm::mix(0.04, color, metallic);
        const double lobe = compensation(f0) * (f0 * a_ + b_);
        const double tabulated = specularAlbedo(model_, glm::dvec3(f0), nDotV_, roughness_).x;
        return lobe + (1.0 - tabulated) * (1.0 - metallic) * color;
    }

  private:
    double compensation(double f0) const {
        if (model_ == BrdfModel::course) return 1.0;
        const double albedo = directionalAlbedo(model_, nDotV_, roughness_);
        return 1.0 + f0 * (1.0 - albedo) / albedo;
    }

    BrdfModel model_;
    double roughness_, nDotV_, a_, b_;
};

TEST(BrdfFurnace, aSurfaceReturnsTheSumOfItsParts) {
    for (BrdfModel model : models)
        for (double roughness : {0.1, 0.6})
            for (double nDotV : {0.02, 0.3, 0.9}) {
                const Returned returned(model, roughness, nDotV, samples);
                EXPECT_NEAR(returned(1.0, 0.0), furnace::whiteDielectric(model, roughness, nDotV, samples),
                            quadratureError);
                EXPECT_NEAR(returned(0.3, 1.0),
                            furnace::specularAlbedo(model, 0.3, roughness, nDotV, samples), quadratureError);
            }
}

// Roughness and angles fall between the rows and columns of the table.
TEST(BrdfFurnace, noSurfaceReturnsMoreThanItReceives) {
    constexpr int coarse = 96;
    for (BrdfModel model : models) {
        double highest = 0.0;
        for (int i = 0; i <= 34; ++i)
            for (int j = 0; j <= 24; ++j) {
                const double nDotV = std::max(std::pow(j / 24.0, 3.0), minNDotV);
                const Returned returned(model, i / 34.0, nDotV, coarse);
                for (double color = 0.0; color <= 1.0; color += 0.125)
                    for (double metallic = 0.0; metallic <= 1.0; metallic += 0.125)
                        highest = std::max(highest, returned(color, metallic));
            }
        // With half of the samples of above.
        EXPECT_LE(highest, 1.0 + 2.0 * quadratureError) << toString(model);
        std::printf("%s: at most %.5f\n", toString(model), highest);
    }
}

// Prints the tables of docs/lighting.md.
TEST(BrdfFurnace, tables) {
    const auto print = [](const char* what, const auto& albedo) {
        std::printf("%s\n", what);
        for (BrdfModel model : models)
            for (double roughness : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
                std::printf("| `%s` %.1f |", toString(model), roughness);
                for (double nDotV : {1.0e-4, 0.01, 0.1, 0.2, 0.4, 0.7, 1.0})
                    std::printf(" %.3f |", albedo(model, roughness, nDotV, samples));
                std::printf("\n");
            }
    };
    print("white metal", furnace::whiteMetal);
    print("white dielectric", furnace::whiteDielectric);
}

}  // namespace
}  // namespace candela
