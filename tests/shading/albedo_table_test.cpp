#include "shading/directional_albedo.h"

#include "furnace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

namespace candela {
namespace {

constexpr int last = albedoTableSize - 1;

/// The albedo by the test's own quadrature of the BRDF, with the compensation taken out again.
double integratedAlbedo(double nDotV, double alpha, int samples) {
    return furnace::whiteMetal(BrdfModel::gltf, std::sqrt(alpha), nDotV, samples) *
           directionalAlbedo(nDotV, alpha);
}

TEST(AlbedoTable, isJustAboveTheIntegral) {
    // Interpolation is worst in the first cells, where E falls from 1 like x log x: 6e-3. The quadrature of
    // the test errs by 2e-4, see brdf_furnace_test.cpp.
    for (double alpha : {minAlpha, 0.004, 0.017, 0.05, 0.1, 0.3, 0.55, 0.8, 0.98, 1.0})
        for (double nDotV : {1.0e-4, 1.0e-3, 4.0e-3, 0.01, 0.03, 0.1, 0.25, 0.5, 0.8, 1.0}) {
            const double excess = directionalAlbedo(nDotV, alpha) - integratedAlbedo(nDotV, alpha, 192);
            EXPECT_GE(excess, -2.0e-4) << "n·v " << nDotV << " alpha " << alpha;
            EXPECT_LE(excess, 8.0e-3) << "n·v " << nDotV << " alpha " << alpha;
        }
}

TEST(AlbedoTable, matchesTheClosedFormAtFullRoughness) {
    // At alpha = 1 and n·v = 1, D is 1/pi and G 2 (n·l) / (1 + n·l): the integral is 1 - ln 2.
    // The table's own quadrature errs by 1.5e-4 there.
    EXPECT_NEAR(directionalAlbedo(1.0, 1.0), 1.0 - std::numbers::ln2 + albedoBias, 2.0e-4);
}

TEST(AlbedoTable, holdsFractionsFromGrazingToNormalIncidence) {
    const std::span<const float> table = directionalAlbedoTable();
    ASSERT_EQ(table.size(), std::size_t(albedoTableSize) * albedoTableSize);
    for (int j = 0; j < albedoTableSize; ++j) {
        EXPECT_EQ(table[std::size_t(j * albedoTableSize)], 1.0f);
        for (int i = 0; i < albedoTableSize; ++i) {
            const float value = table[std::size_t(j * albedoTableSize + i)];
            EXPECT_TRUE(value > 0.3f && value <= 1.0f) << i << ", " << j << ": " << value;
        }
    }
}

// The header's parametrisation: at a texel's position it gives the texel's value.
TEST(AlbedoTable, texelsLieOnTheCornersOfTheCells) {
    for (int j = 0; j < albedoTableSize; ++j)
        for (int i = 1; i < albedoTableSize; ++i) {
            const double alpha = minAlpha + (1.0 - minAlpha) * j / last;
            const double x = double(i) / last, nDotV = x * alpha / (1.0 + alpha - x);
            if (nDotV < minNDotV) continue;
            // Rounding moves the position by 1e-14 cells.
            EXPECT_NEAR(directionalAlbedo(nDotV, alpha),
                        directionalAlbedoTable()[std::size_t(j * albedoTableSize + i)], 1.0e-10);
        }
}

TEST(AlbedoTable, argumentsAreClampedToTheDomain) {
    EXPECT_EQ(directionalAlbedo(-1.0, 0.5), directionalAlbedo(minNDotV, 0.5));
    EXPECT_EQ(directionalAlbedo(0.001, 0.0), directionalAlbedo(0.001, minAlpha));
}

TEST(AlbedoTable, isSharedBetweenThreads) {
    std::vector<const float*> seen(8);
    std::vector<std::thread> threads;
    for (const float*& data : seen) threads.emplace_back([&data] { data = directionalAlbedoTable().data(); });
    for (std::thread& thread : threads) thread.join();
    for (const float* data : seen) EXPECT_EQ(data, seen[0]);
}

}  // namespace
}  // namespace candela
