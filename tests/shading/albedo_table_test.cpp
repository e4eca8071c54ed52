#include "shading/directional_albedo.h"

#include "furnace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

namespace candela {
namespace {

constexpr BrdfModel models[] = {BrdfModel::course, BrdfModel::gltf};

constexpr double last = albedoTableSize - 1;

/// Of the test's quadrature, see brdf_furnace_test.cpp.
constexpr double quadratureError = 2.0e-4;

/// What the lobe reflects by the test's own quadrature of the BRDF, with the compensation taken out again.
double integratedAlbedo(BrdfModel model, double f0, double nDotV, double roughness) {
    const double albedo = furnace::specularAlbedo(model, f0, roughness, nDotV, 128);
    if (model == BrdfModel::course) return albedo;
    const double table = directionalAlbedo(model, nDotV, roughness);
    return albedo / (1.0 + f0 * (1.0 - table) / table);
}

/// The same by the table.
double tabulatedAlbedo(BrdfModel model, double f0, double nDotV, double roughness) {
    const LobeAlbedo lobe = lobeAlbedo(model, nDotV, roughness);
    return lobe.albedo * (f0 + (1.0 - f0) * lobe.fresnelWeight);
}

TEST(AlbedoTable, isJustAboveTheIntegral) {
    for (BrdfModel model : models)
        for (double f0 : {0.0, 0.04, 1.0})
            for (double roughness : {0.0, 0.02, 0.05, 0.12, 0.2, 0.33, 0.55, 0.75, 0.9, 0.99, 1.0})
                for (double nDotV : {1.0e-4, 1.0e-3, 4.0e-3, 0.01, 0.03, 0.1, 0.25, 0.5, 0.8, 1.0}) {
                    const double excess = tabulatedAlbedo(model, f0, nDotV, roughness) -
                                          integratedAlbedo(model, f0, nDotV, roughness);
                    EXPECT_GE(excess, -quadratureError)
                        << toString(model) << " F0 " << f0 << " n·v " << nDotV << " roughness " << roughness;
                    // The biases, and the interpolation in the first cells, where E of `gltf` falls from 1
                    // like x log x.
                    EXPECT_LE(excess, 8.0e-3)
                        << toString(model) << " F0 " << f0 << " n·v " << nDotV << " roughness " << roughness;
                }
}

TEST(AlbedoTable, matchesTheClosedFormAtFullRoughness) {
    // At alpha = 1 and n·v = 1, D is 1/pi and the G of `gltf` 2 (n·l) / (1 + n·l): the integral is 1 - ln 2.
    // That of `course`, with k = 1/2, is half of it times 2. The table's own quadrature errs by 1.5e-4 there.
    const double integral = 1.0 - std::numbers::ln2;
    EXPECT_NEAR(directionalAlbedo(BrdfModel::gltf, 1.0, 1.0), integral + gltfAlbedoBias.offset, 2.0e-4);
    EXPECT_NEAR(directionalAlbedo(BrdfModel::course, 1.0, 1.0), integral * courseAlbedoBias.factor, 2.0e-4);
}

TEST(AlbedoTable, aMirrorReflectsFresnelTimesMasking) {
    // Where n·v is much more than the minimum alpha, which is 0.001.
    for (double nDotV : {0.1, 0.3, 0.7, 1.0}) {
        const double fresnel = 0.04 + 0.96 * std::pow(1.0 - nDotV, 5.0);
        const double masking = geometrySchlickSmith(nDotV, nDotV, 0.0);
        EXPECT_NEAR(specularAlbedo(BrdfModel::gltf, glm::dvec3(0.04), nDotV, 0.0).x, fresnel, 5.0e-3);
        EXPECT_NEAR(specularAlbedo(BrdfModel::course, glm::dvec3(0.04), nDotV, 0.0).x, fresnel * masking,
                    5.0e-3);
    }
}

TEST(AlbedoTable, holdsPositiveNumbers) {
    for (BrdfModel model : models) {
        const std::span<const float> table = directionalAlbedoTable(model);
        ASSERT_EQ(table.size(), std::size_t(2 * albedoTableSize * albedoTableSize));
        for (const float value : table) EXPECT_TRUE(value > 0.1f && value < 50.0f) << value;
    }
}

// The header's parametrisation: at a texel's position it gives the texel's value.
TEST(AlbedoTable, texelsLieOnTheCornersOfTheCells) {
    const std::span<const float> table = directionalAlbedoTable(BrdfModel::gltf);
    for (int j = 0; j < albedoTableSize; ++j)
        for (int i = 1; i < albedoTableSize; ++i) {
            const double roughness = j / last, alpha = std::max(roughness * roughness, minAlpha);
            const double x = i / last, nDotV = x * alpha / (1.0 + alpha - x);
            if (nDotV < minNDotV) continue;
            const LobeAlbedo lobe = lobeAlbedo(BrdfModel::gltf, nDotV, roughness);
            const float* texel = table.data() + 2 * (j * albedoTableSize + i);
            // Rounding moves the position by 1e-14 cells.
            EXPECT_NEAR(lobe.albedo, texel[0], 1.0e-10);
            EXPECT_NEAR(1.0 - std::pow(lobe.fresnelWeight, 0.2), texel[1] * (nDotV + alpha), 1.0e-10);
        }
}

TEST(AlbedoTable, argumentsAreClampedToTheDomain) {
    for (BrdfModel model : models)
        EXPECT_EQ(directionalAlbedo(model, -1.0, 0.5), directionalAlbedo(model, minNDotV, 0.5));
    EXPECT_EQ(directionalAlbedo(BrdfModel::gltf, 0.5, 1.0e-9), directionalAlbedo(BrdfModel::gltf, 0.5, 0.0));
}

TEST(AlbedoTable, isSharedBetweenThreads) {
    for (BrdfModel model : models) {
        std::vector<const float*> seen(8);
        std::vector<std::thread> threads;
        for (const float*& data : seen)
            threads.emplace_back([&data, model] { data = directionalAlbedoTable(model).data(); });
        for (std::thread& thread : threads) thread.join();
        for (const float* data : seen) EXPECT_EQ(data, seen[0]);
    }
}

}  // namespace
}  // namespace candela
