#include "color/ocio.h"

#include <candela/color.h>

#include "color/display_shader.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace candela {
namespace {

using Names = std::vector<std::string>;
using Color = std::array<float, 4>;

const Names allDisplays{"sRGB", "Rec.1886", "Display P3", "P3-D65"};

Color shown(const char* display, const char* view, Color color, double exposure = 0.0) {
    ColorConfig::builtIn().displayTransform({display, view, "", exposure}).apply(color);
    return color;
}

void expectColor(const Color& actual, const Color& expected, double tolerance) {
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "channel " << i;
}

double srgbCode(double light) {
    return 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

// Single precision through a few matrices and a power.
constexpr double rounding = 2e-5;

TEST(BuiltInConfig, passesOpenColorIOsValidation) {
    EXPECT_NO_THROW(builtInConfig()->validate());
}

TEST(BuiltInConfig, hasTheDocumentedNames) {
    const ColorConfig config = ColorConfig::builtIn();
    EXPECT_EQ(config.source(), "built-in");
    EXPECT_EQ(config.displays(), allDisplays);
    for (const std::string& display : allDisplays) {
        EXPECT_EQ(config.views(display), (Names{"Un-tone-mapped", "ACES 1.0 SDR", "Raw"})) << display;
        EXPECT_EQ(config.defaultView(display), "Un-tone-mapped") << display;
    }
    EXPECT_EQ(config.defaultDisplay(), "sRGB");
    EXPECT_TRUE(config.looks().empty());
    EXPECT_TRUE(config.notes().empty());
}

TEST(BuiltInConfig, worksInLinearRec709) {
    const ColorConfig config = ColorConfig::builtIn();
    EXPECT_EQ(config.workingSpace(), "Linear Rec.709");
    EXPECT_EQ(config.workingFromRec709(), glm::dmat3(1.0)) << "colours of files need no conversion";
    EXPECT_EQ(config.chromaticities().red, Chromaticities{}.red);
    EXPECT_EQ(config.chromaticities().white, Chromaticities{}.white);
}

TEST(BuiltInConfig, everyViewHasTransformAndShader) {
    const ColorConfig config = ColorConfig::builtIn();
    for (const std::string& display : config.displays())
        for (const std::string& view : config.views(display)) {
            const DisplayTransform transform = config.displayTransform({display, view, "", 0.0});
            EXPECT_EQ(transform.options().display, display);
            EXPECT_EQ(transform.options().view, view);
            EXPECT_NE(displayShader(transform).glsl.find("displayTransform"), std::string::npos);
        }
}

TEST(BuiltInConfig, rawShowsValuesUnchanged) {
    for (const std::string& display : allDisplays)
        expectColor(shown(display.c_str(), "Raw", {0.25f, 0.5f, 0.125f, 1.0f}), {0.25f, 0.5f, 0.125f, 1.0f},
                    0.0);
}

TEST(BuiltInConfig, unToneMappedIsTheDisplaysCurve) {
    const Color grey{0.18f, 0.18f, 0.18f, 1.0f};
    const auto greyOf = [](double code) { return Color{float(code), float(code), float(code), 1.0f}; };
    expectColor(shown("sRGB", "Un-tone-mapped", grey), greyOf(srgbCode(0.18)), rounding);
    expectColor(shown("Rec.1886", "Un-tone-mapped", grey), greyOf(std::pow(0.18, 1 / 2.4)), rounding);
    expectColor(shown("Display P3", "Un-tone-mapped", grey), greyOf(srgbCode(0.18)), rounding);
    expectColor(shown("P3-D65", "Un-tone-mapped", grey), greyOf(std::pow(0.18, 1 / 2.6)), rounding);
    EXPECT_EQ(std::lround(255.0f * shown("sRGB", "Un-tone-mapped", grey)[0]), 118);
}

TEST(BuiltInConfig, rec709RedOnDisplayP3) {
    // Linear P3 of Rec.709's red is (0.822462, 0.033194, 0.017083): the first column of P3-D65 from Rec.709.
    const Color expected{float(srgbCode(0.822462)), float(srgbCode(0.033194)), float(srgbCode(0.017083)),
                         1.0f};
    expectColor(shown("Display P3", "Un-tone-mapped", {1, 0, 0, 1}), expected, rounding);
}

TEST(BuiltInConfig, acesViewRendersGreyAndRollsOff) {
    // ACES 1.0 puts mid grey (0.18) at 4.8 cd/m² of a 48 cd/m² cinema white: a tenth of white. The video
    // transform lifts it for a dim room: luminance to the power of 0.9811 (ACES's DIM_SURROUND_GAMMA).
    const double grey = std::pow(0.1, 0.9811);
    const float code = shown("sRGB", "ACES 1.0 SDR", {0.18f, 0.18f, 0.18f, 1.0f})[0];
    EXPECT_NEAR(code, srgbCode(grey), 2e-3)
        << "half an 8-bit code: ACES's spline meets 4.8 cd/m² that closely";
    const float one = shown("sRGB", "ACES 1.0 SDR", {1, 1, 1, 1})[0];
    const float eight = shown("sRGB", "ACES 1.0 SDR", {8, 8, 8, 1})[0];
    EXPECT_LT(one, 0.9f);
    EXPECT_GT(eight, one + 0.05f) << "highlights beyond 1 stay distinguishable";
}

TEST(BuiltInConfig, acesViewHasNoTintOnAnyDisplay) {
    for (const std::string& display : allDisplays) {
        const Color grey = shown(display.c_str(), "ACES 1.0 SDR", {0.5f, 0.5f, 0.5f, 1.0f});
        EXPECT_NEAR(grey[0], grey[1], 1e-4) << display << ": matrices of seven digits through a power";
        EXPECT_NEAR(grey[2], grey[1], 1e-4) << display;
    }
}

TEST(BuiltInConfig, encodingsForTags) {
    const ColorConfig config = ColorConfig::builtIn();
    const auto encoding = [&](const char* display, const char* view) {
        return config.displayTransform({display, view, "", 0.0}).encoding();
    };
    using Transfer = DisplayEncoding::Transfer;
    for (const char* view : {"Un-tone-mapped", "ACES 1.0 SDR"}) {
        EXPECT_EQ(encoding("sRGB", view).transfer, Transfer::srgb);
        EXPECT_EQ(encoding("sRGB", view).chromaticities->red, glm::dvec2(0.64, 0.33));
        EXPECT_EQ(encoding("Rec.1886", view).transfer, Transfer::gamma);
        EXPECT_EQ(encoding("Rec.1886", view).gamma, 2.4);
        EXPECT_EQ(encoding("Rec.1886", view).chromaticities->red, glm::dvec2(0.64, 0.33));
        EXPECT_EQ(encoding("Display P3", view).transfer, Transfer::srgb);
        EXPECT_EQ(encoding("Display P3", view).chromaticities->red, glm::dvec2(0.68, 0.32));
        EXPECT_EQ(encoding("P3-D65", view).transfer, Transfer::gamma);
        EXPECT_EQ(encoding("P3-D65", view).gamma, 2.6);
        EXPECT_EQ(encoding("P3-D65", view).chromaticities->red, glm::dvec2(0.68, 0.32));
    }
    for (const std::string& display : allDisplays) {
        EXPECT_EQ(encoding(display.c_str(), "Raw").transfer, Transfer::unknown);
        EXPECT_FALSE(encoding(display.c_str(), "Raw").chromaticities);
    }
}

}  // namespace
}  // namespace candela
