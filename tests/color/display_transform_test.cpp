#include <candela/color.h>
#include <candela/error.h>

#include "ramps.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace candela {
namespace {

using Color = std::array<float, 4>;

const ColorConfig& luts() {
    static const ColorConfig config = ColorConfig::load(CANDELA_TEST_DATA "/config/luts.ocio");
    return config;
}

Color shown(const DisplayTransform& transform, Color color) {
    transform.apply(color);
    return color;
}

Color shown(const ColorConfig& config, const DisplayOptions& options, const Color& color) {
    return shown(config.displayTransform(options), color);
}

TEST(DisplayTransform, exposureIsInStops) {
    const ColorConfig config = ColorConfig::builtIn();
    const Color two = shown(config, {"", "Raw", "", 2.0}, {0.125f, 0.0625f, 0.25f, 1.0f});
    EXPECT_EQ(two, (Color{0.5f, 0.25f, 1.0f, 1.0f}));
    const Color minusOne = shown(config, {"", "Raw", "", -1.0}, {0.5f, 1.0f, 2.0f, 1.0f});
    EXPECT_EQ(minusOne, (Color{0.25f, 0.5f, 1.0f, 1.0f}));
}

TEST(DisplayTransform, alphaIsUnchanged) {
    for (const float alpha : {0.0f, 0.25f, 1.0f, 7.0f}) {
        EXPECT_EQ(shown(ColorConfig::builtIn(), {"", "", "", 3.0}, {0.1f, 0.2f, 0.3f, alpha})[3], alpha);
        EXPECT_EQ(shown(luts(), {"Monitor", "Film and print", "faded", 0.0}, {0.1f, 0.2f, 0.3f, alpha})[3],
                  alpha);
    }
}

TEST(DisplayTransform, nonFiniteNumbers) {
    using Limits = std::numeric_limits<float>;
    const DisplayTransform raw = ColorConfig::builtIn().displayTransform({"", "Raw", "", 0.0});
    EXPECT_EQ(shown(raw, {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), 1.0f}),
              (Color{0.0f, 1.0f, 0.0f, 1.0f}));
    EXPECT_EQ(shown(raw, {-0.5f, 1.5f, 0.5f, 1.0f}), (Color{0.0f, 1.0f, 0.5f, 1.0f}));
    // An infinite channel is shown as the brightest finite one is.
    const DisplayTransform aces = ColorConfig::builtIn().displayTransform({"", "ACES 1.0 SDR", "", 0.0});
    EXPECT_EQ(shown(aces, {Limits::infinity(), 1.0f, 1.0f, 1.0f}), shown(aces, {65504.0f, 1.0f, 1.0f, 1.0f}));
    EXPECT_EQ(shown(aces, {Limits::quiet_NaN(), 1.0f, 1.0f, 1.0f}), shown(aces, {0.0f, 1.0f, 1.0f, 1.0f}));
}

TEST(DisplayTransform, everyInputGivesCodesFromZeroToOne) {
    for (const ColorConfig& config : {ColorConfig::builtIn(), luts()})
        for (const std::string& display : config.displays())
            for (const std::string& view : config.views(display)) {
                if (view == "Missing") continue;  // a view whose table is missing
                std::vector<float> pixels = test::Ramps::all();
                config.displayTransform({display, view, "", 0.0}).apply(pixels);
                for (const float code : pixels) ASSERT_TRUE(code >= 0.0f && code <= 1.0f) << display << view;
            }
}

TEST(DisplayTransform, anyNumberOfPixels) {
    const DisplayTransform transform = ColorConfig::builtIn().displayTransform({});
    const Color expected = shown(transform, {0.1f, 0.2f, 0.3f, 0.4f});
    for (const std::size_t count : {0, 1, 4095, 4096, 4097, 10000}) {
        std::vector<float> pixels;
        for (std::size_t i = 0; i < count; ++i) pixels.insert(pixels.end(), {0.1f, 0.2f, 0.3f, 0.4f});
        transform.apply(pixels);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            ASSERT_EQ(pixels[i], expected[i % 4]) << i << " of " << count;
    }
}

TEST(DisplayTransform, tablesAreApplied) {
    // mono.spi1d holds x^(1/2.2) at 33 points; 0.25 is one of them, so that nothing is interpolated.
    const Color mono = shown(luts(), {"Monitor", "Mono", "", 0.0}, {0.25f, 0.25f, 0.25f, 1.0f});
    EXPECT_NEAR(mono[0], std::pow(0.25, 1.0 / 2.2), 1e-6) << "six digits in the file";
    const Color rgb = shown(luts(), {"Monitor", "RGB", "", 0.0}, {0.25f, 0.25f, 0.25f, 1.0f});
    EXPECT_NEAR(rgb[1], 0.5, 1e-6);
    EXPECT_NE(rgb[0], rgb[2]);
    const Color cube = shown(luts(), {"Monitor", "Tetrahedral", "", 0.0}, {100.0f, 0.0f, 0.0f, 1.0f});
    // Red of full strength in film.cube's sixth entry (line 8 of the file).
    EXPECT_NEAR(cube[0], 0.89251, 1e-4);
}

TEST(DisplayTransform, aLookReplacesTheViewsOwn) {
    const Color grey{0.25f, 0.25f, 0.25f, 1.0f};
    const Color plain = shown(luts(), {"Monitor", "Mono", "", 0.0}, grey);
    const Color warm = shown(luts(), {"Monitor", "Mono", "warm", 0.0}, grey);
    EXPECT_GT(warm[0], plain[0] + 0.01f);
    EXPECT_LT(warm[2], plain[2] - 0.01f);
    EXPECT_EQ(shown(luts(), {"Monitor", "Graded", "", 0.0}, grey), warm) << "the view's own look";
    EXPECT_EQ(shown(luts(), {"Monitor", "Graded", "warm", 0.0}, grey), warm) << "is not applied twice";
    const Color faded = shown(luts(), {"Monitor", "Mono", "faded", 0.0}, grey);
    EXPECT_EQ(shown(luts(), {"Monitor", "Graded", "faded", 0.0}, grey), faded);
    EXPECT_NE(faded, plain);
}

TEST(DisplayTransform, looksCombineInOpenColorIOSyntax) {
    const Color grey{0.25f, 0.25f, 0.25f, 1.0f};
    const Color plain = shown(luts(), {"Monitor", "Mono", "", 0.0}, grey);
    const Color roundTrip = shown(luts(), {"Monitor", "Mono", "+warm, -warm", 0.0}, grey);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(roundTrip[i], plain[i], 1e-6) << "single precision";
}

TEST(DisplayTransform, encodingOfOtherConfigs) {
    EXPECT_EQ(luts().displayTransform({}).encoding().transfer, DisplayEncoding::Transfer::unknown)
        << "a config that does not state its displays' encodings";
}

TEST(DisplayTransform, refusesIncompletePixels) {
    const DisplayTransform transform = ColorConfig::builtIn().displayTransform({});
    std::vector<float> numbers(7);
    EXPECT_THROW(transform.apply(numbers), Error);
}

TEST(DisplayTransform, aMovedFromHandleStillHasItsTransform) {
    ColorConfig config = ColorConfig::builtIn();
    const ColorConfig movedConfig = std::move(config);
    EXPECT_EQ(config.source(), movedConfig.source());
    DisplayTransform transform = config.displayTransform({});
    const DisplayTransform moved = std::move(transform);
    EXPECT_EQ(transform.options().display, moved.options().display);
}

}  // namespace
}  // namespace candela
