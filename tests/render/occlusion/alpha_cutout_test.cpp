// Rays read the alpha of masked materials as textures are read.

#include "render/occlusion/occlusion_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace candela {
namespace {

constexpr glm::vec3 middle(1.0f / 3.0f);

/// One triangle that reads a point of an image.
struct Cutout {
    Cutout(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> alpha) {
        mesh.images.push_back(
            std::make_shared<const AlphaImage>(AlphaImage{width, height, std::move(alpha)}));
        CutoutTriangle triangle{};
        std::fill_n(triangle.alpha, 3, 1.0f);
        mesh.cutouts.push_back(triangle);
    }

    CutoutTriangle& triangle() { return mesh.cutouts.front(); }

    /// The alpha that the ray meets, by bisection of the cutoff.
    float alphaAt(const glm::vec2& uv) {
        std::fill_n(triangle().uv, 3, uv);
        float low = -1.0f, high = 3.0f;
        for (int i = 0; i < 30; ++i) {
            triangle().cutoff = 0.5f * (low + high);
            (transmittance(mesh, 0, middle) == 1.0f ? high : low) = triangle().cutoff;
        }
        return 0.5f * (low + high);
    }

    OcclusionMesh mesh;
};

// Of the bisection, and of weights whose sum is 1 but for rounding.
constexpr float tolerance = 1.0e-6f;

TEST(AlphaCutout, ReadsTexelsAtTheirCentersAndInterpolatesBetween) {
    Cutout cutout(2, 2, {0, 255, 51, 102});
    EXPECT_NEAR(cutout.alphaAt({0.25f, 0.25f}), 0.0f, tolerance);
    EXPECT_NEAR(cutout.alphaAt({0.75f, 0.25f}), 1.0f, tolerance);
    EXPECT_NEAR(cutout.alphaAt({0.25f, 0.75f}), 0.2f, tolerance);
    EXPECT_NEAR(cutout.alphaAt({0.75f, 0.75f}), 0.4f, tolerance);
    EXPECT_NEAR(cutout.alphaAt({0.5f, 0.25f}), 0.5f, tolerance);
    EXPECT_NEAR(cutout.alphaAt({0.5f, 0.5f}), 0.4f, tolerance);
}

TEST(AlphaCutout, NearestTakesTheTexelThatHoldsThePoint) {
    Cutout cutout(2, 1, {0, 255});
    cutout.triangle().nearest = true;
    EXPECT_NEAR(cutout.alphaAt({0.49f, 0.5f}), 0.0f, tolerance);
    EXPECT_NEAR(cutout.alphaAt({0.51f, 0.5f}), 1.0f, tolerance);
}

TEST(AlphaCutout, WrapModesContinueTheImage) {
    Cutout cutout(2, 1, {0, 255});
    for (const float period : {-3.0f, 0.0f, 4.0f}) {
        EXPECT_NEAR(cutout.alphaAt({period + 0.25f, 0.5f}), 0.0f, tolerance);
        EXPECT_NEAR(cutout.alphaAt({period + 0.75f, 0.5f}), 1.0f, tolerance);
        // Between the last texel and the first of the next period.
        EXPECT_NEAR(cutout.alphaAt({period + 1.0f, 0.5f}), 0.5f, tolerance);
    }
    cutout.triangle().wrapS = AlphaWrap::clampToEdge;
    EXPECT_NEAR(cutout.alphaAt({-7.0f, 0.5f}), 0.0f, tolerance);
    EXPECT_NEAR(cutout.alphaAt({0.1f, 0.5f}), 0.0f, tolerance);
    EXPECT_NEAR(cutout.alphaAt({5.0f, 0.5f}), 1.0f, tolerance);
    cutout.triangle().wrapS = AlphaWrap::mirroredRepeat;
    EXPECT_NEAR(cutout.alphaAt({1.25f, 0.5f}), 1.0f, tolerance);
    EXPECT_NEAR(cutout.alphaAt({1.75f, 0.5f}), 0.0f, tolerance);
    EXPECT_NEAR(cutout.alphaAt({-0.25f, 0.5f}), 0.0f, tolerance);
    EXPECT_NEAR(cutout.alphaAt({2.25f, 0.5f}), 0.0f, tolerance);
    EXPECT_NEAR(cutout.alphaAt({1.0f, 0.5f}), 1.0f, tolerance);
}

TEST(AlphaCutout, FactorsMultiplyTheImage) {
    Cutout cutout(1, 1, {255});
    cutout.triangle().alpha[0] = 0.3f;
    cutout.triangle().alpha[1] = 0.6f;
    cutout.triangle().alpha[2] = 0.9f;
    EXPECT_NEAR(cutout.alphaAt({0.5f, 0.5f}), 0.6f, tolerance);
    cutout.triangle().image = CutoutTriangle::noImage;
    EXPECT_NEAR(cutout.alphaAt({0.5f, 0.5f}), 0.6f, tolerance);
}

TEST(AlphaCutout, AnAlphaEqualToTheCutoffHidesTheLight) {
    Cutout cutout(1, 1, {255});
    std::fill_n(cutout.triangle().alpha, 3, 0.5f);
    cutout.triangle().cutoff = 0.5f;
    EXPECT_EQ(transmittance(cutout.mesh, 0, {1.0f, 0.0f, 0.0f}), 0.0f);
}

}  // namespace
}  // namespace candela
