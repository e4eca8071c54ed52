#include "panels/panel_values.h"
#include "panels/color_values.h"

#include <gtest/gtest.h>

#include <array>

namespace {

FrameRecord frame(double milliseconds, std::vector<candela::PassTime> passes) {
    return {std::move(passes), milliseconds};
}

TEST(FrameSummary, IsEmptyWithoutFrames) {
    EXPECT_FALSE(summarise({}));
}

TEST(FrameSummary, GivesLastAndMedianOfEachPass) {
    const auto summary =
        summarise({frame(10.0, {{"geometry", 2.0}, {"lighting", 7.0}}), frame(30.0, {{"geometry", 4.0}}),
                   frame(20.0, {{"geometry", 9.0}, {"overlays", 1.0}})});
    ASSERT_TRUE(summary);
    EXPECT_EQ(summary->last, 20.0);
    EXPECT_EQ(summary->median, 20.0);
    EXPECT_EQ(summary->max, 30.0);
    ASSERT_EQ(summary->passes.size(), 3u);
    EXPECT_EQ(summary->passes[0].name, "geometry");
    EXPECT_EQ(summary->passes[0].last, 9.0);
    EXPECT_EQ(summary->passes[0].median, 4.0);
    EXPECT_EQ(summary->passes[1].name, "lighting");
    EXPECT_FALSE(summary->passes[1].last);
    EXPECT_EQ(summary->passes[1].median, 7.0);
    EXPECT_EQ(summary->passes[2].last, 1.0);
}

TEST(FrameSummary, AddsUpAPassThatRanTwice) {
    const auto summary = summarise({frame(10.0, {{"tiles", 2.0}, {"tiles", 3.0}})});
    ASSERT_TRUE(summary);
    EXPECT_EQ(summary->passes[0].last, 5.0);
}

TEST(RoundedUp, GivesTheNextRoundNumber) {
    EXPECT_DOUBLE_EQ(roundedUp(16.7), 20.0);
    EXPECT_DOUBLE_EQ(roundedUp(0.3), 0.5);
    EXPECT_DOUBLE_EQ(roundedUp(51.0), 100.0);
    EXPECT_DOUBLE_EQ(roundedUp(2.0), 2.0);
}

TEST(Texts, GroupDigits) {
    EXPECT_EQ(groupedText(0), "0");
    EXPECT_EQ(groupedText(999), "999");
    EXPECT_EQ(groupedText(1000), "1,000");
    EXPECT_EQ(groupedText(1234567), "1,234,567");
}

TEST(Texts, CountOneAndMany) {
    EXPECT_EQ(countText(0, "light"), "0 lights");
    EXPECT_EQ(countText(1, "light"), "1 light");
    EXPECT_EQ(countText(4096, "light"), "4,096 lights");
    EXPECT_EQ(countText(2, "mesh", "meshes"), "2 meshes");
}

TEST(Texts, FormatBytesWithAUnit) {
    EXPECT_EQ(bytesText(512), "512 B");
    EXPECT_EQ(bytesText(1536), "1.5 KiB");
    EXPECT_EQ(bytesText(20u << 20), "20.0 MiB");
    EXPECT_EQ(bytesText(std::uint64_t{5} << 40), "5.0 TiB");
}

TEST(Texts, NameElements) {
    EXPECT_EQ(elementText("material", 3, "brass"), "material 3 brass");
    EXPECT_EQ(elementText("node", 0, ""), "node 0");
}

TEST(Texts, AddAnExtensionOnce) {
    EXPECT_EQ(withEnding("picture", ".png"), "picture.png");
    EXPECT_EQ(withEnding("picture.png", ".png"), "picture.png");
    EXPECT_EQ(withEnding("picture.exr", ".png"), "picture.exr.png");
}

TEST(Srgb, RoundTrips) {
    for (const float value : {0.0f, 0.002f, 0.0031308f, 0.01f, 0.18f, 0.5f, 1.0f}) {
        // Rounding of two powers in single precision.
        EXPECT_NEAR(linearFromSrgb(srgbFromLinear(glm::vec3(value))).r, value, 2.0e-6f);
    }
    // 0.214041 is the linear value of a code of 0.5: ((0.5 + 0.055) / 1.055)^2.4.
    EXPECT_NEAR(linearFromSrgb(glm::vec3(0.5f)).g, 0.214041f, 1.0e-6f);
}

TEST(Srgb, ClampsToTheDisplayRange) {
    EXPECT_EQ(srgbFromLinear(glm::vec3(7.0f)), srgbFromLinear(glm::vec3(1.0f)));
    EXPECT_EQ(srgbFromLinear(glm::vec3(-1.0f)), glm::vec3(0.0f));
}

}  // namespace
