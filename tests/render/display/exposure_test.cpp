// Automatic exposure and the counts that pictures are judged by.

#include <candela/error.h>
#include <candela/exposure.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace candela::test {
namespace {

constexpr glm::vec3 weights{0.25f, 0.5f, 0.25f};

/// One row of grey pixels; a negative one is background.
HdrImage imageOf(const std::vector<float>& greys) {
    HdrImage image{static_cast<int>(greys.size()), 1, {}};
    for (const float grey : greys) {
        const bool surface = grey >= 0.0f;
        for (int i = 0; i < 3; ++i) image.rgba.push_back(surface ? grey : 0.0f);
        image.rgba.push_back(surface ? 1.0f : 0.0f);
    }
    return image;
}

TEST(Exposure, CountsSurfacesByTheirLuminance) {
    const HdrImage image = imageOf({-1.0f, 0.0f, 1e-6f, 0.5f, 1.5f, 3.0f});
    const ExposureCounts counts = countExposure(image, weights, 0.0);
    EXPECT_EQ(counts.surfaces, 5u);
    EXPECT_EQ(counts.lit, 4u);
    EXPECT_EQ(counts.overBlack, 3u);
    EXPECT_EQ(counts.overWhite, 2u);
    EXPECT_EQ(countExposure(image, weights, -1.0).overWhite, 1u);
    EXPECT_EQ(countExposure(image, weights, 10.0).overBlack, 4u);
}

TEST(Exposure, TheMedianOfWhatIsLitBecomesMidGrey) {
    const std::vector<HdrImage> frames{imageOf({-1.0f, 0.0f, 0.36f, 9.0f}), imageOf({0.01f, 0.36f, 0.36f})};
    EXPECT_NEAR(*autoExposure(frames, weights), -1.0, 1e-6);
}

TEST(Exposure, NothingLitHasNoExposure) {
    const std::vector<HdrImage> frames{imageOf({-1.0f, 0.0f})};
    EXPECT_FALSE(autoExposure(frames, weights));
    EXPECT_FALSE(autoExposure({}, weights));
}

TEST(Exposure, StaysWithinWhatADisplayTransformTakes) {
    const std::vector<HdrImage> frames{imageOf({1e-38f})};
    EXPECT_EQ(*autoExposure(frames, weights), 100.0);
}

TEST(Exposure, RefusesAnImageOfAnotherSize) {
    HdrImage image = imageOf({0.5f});
    image.width = 2;
    EXPECT_THROW(countExposure(image, weights, 0.0), Error);
    EXPECT_THROW(autoExposure({&image, 1}, weights), Error);
}

}  // namespace
}  // namespace candela::test
