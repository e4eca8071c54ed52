#include "color/baked_transform.h"

#include "color/display_transform.h"
#include "ramps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace candela {
namespace {

DisplayTransform aces(const std::string& display) {
    return ColorConfig::builtIn().displayTransform({display, "ACES 1.0 SDR", "", 0.0});
}

/// Every channel at every level from 0 to 16 with every other, 48 levels evenly spread over octaves.
std::vector<float> logCube() {
    std::vector<float> levels{0.0f};
    for (int i = 0; i < 47; ++i) levels.push_back(std::exp2(-12.0f + 16.0f * float(i) / 46.0f));
    std::vector<float> colors;
    for (const float red : levels)
        for (const float green : levels)
            for (const float blue : levels) colors.insert(colors.end(), {red, green, blue, 1.0f});
    return colors;
}

struct Errors {
    double mean, percentile99, max;  ///< 8-bit codes.
};

Errors errorsOf(const DisplayTransform& transform, std::vector<float> colors) {
    const auto baked = BakedTransform::make(transform.state().processor);
    if (!baked) throw std::runtime_error("not baked");
    std::vector<float> expected = colors;
    transform.apply(expected);
    for (float& value : colors) value = sanitizedRadiance(value);
    baked->apply(colors);
    std::vector<double> errors;
    for (std::size_t i = 0; i < colors.size(); ++i)
        if (i % 4 != 3) errors.push_back(255.0 * std::abs(sanitizedCode(colors[i]) - expected[i]));
    double sum = 0.0;
    for (const double error : errors) sum += error;
    std::ranges::sort(errors);
    return {sum / double(errors.size()), errors[errors.size() * 99 / 100], errors.back()};
}

// The bounds that docs/color.md promises. The largest errors are near black, where a saturated colour leaves
// little of a channel and a display's gamma is steep.
void expectWithinBounds(const char* colors, const std::string& display, const Errors& errors) {
    SCOPED_TRACE(display + ", " + colors);
    std::printf("%-10s %-10s mean %.4f  p99 %.4f  max %.4f codes\n", display.c_str(), colors, errors.mean,
                errors.percentile99, errors.max);
    EXPECT_LE(errors.mean, 0.002);
    EXPECT_LE(errors.percentile99, 0.02);
    EXPECT_LE(errors.max, 0.25);
}

TEST(BakedTransform, hasAnErrorBelowAQuarterCode) {
    for (const std::string& display : ColorConfig::builtIn().displays()) {
        const DisplayTransform transform = aces(display);
        expectWithinBounds("cube", display, errorsOf(transform, logCube()));
        expectWithinBounds("ramps", display, errorsOf(transform, test::Ramps::all()));
        expectWithinBounds("scattered", display, errorsOf(transform, test::Ramps().scattered(200000).rgba()));
    }
}

TEST(BakedTransform, isNotCreatedForCheapTransforms) {
    const ColorConfig config = ColorConfig::builtIn();
    for (const std::string& display : config.displays())
        for (const char* view : {"Un-tone-mapped", "Raw"}) {
            const DisplayTransform transform = config.displayTransform({display, view, "", 0.0});
            EXPECT_FALSE(BakedTransform::make(transform.state().processor)) << display << ", " << view;
            EXPECT_EQ(bakedDisplayShader(transform), nullptr);
        }
}

TEST(BakedTransform, isNotCreatedBeyondTheErrorLimit) {
    const ColorConfig config = ColorConfig::load(CANDELA_TEST_DATA "/config/luts.ocio");
    int refused = 0;
    for (const char* view : {"Mono", "RGB", "Inverse", "Tetrahedral", "Trilinear", "Film and print"}) {
        const DisplayTransform transform = config.displayTransform({"Monitor", view, "", 0.0});
        if (BakedTransform::make(transform.state().processor))
            EXPECT_LE(errorsOf(transform, logCube()).max, BakedTransform::errorLimit) << view;
        else
            ++refused;
    }
    EXPECT_GE(refused, 5) << "single-step transforms are not baked";
}

TEST(CurveTable, approximatesPowersFromZeroToTheMaxRadiance) {
    const CurveTable table([](std::span<CurveTable::Values> numbers) {
        for (CurveTable::Values& n : numbers)
            n = {std::pow(n.red, 1.0f / 2.6f), std::pow(n.green, 1.0f / 2.4f), n.blue};
    });
    EXPECT_FALSE(table.isShared());
    EXPECT_EQ(table.at(0, -1.0f), 0.0f);
    EXPECT_EQ(table.at(0, -65504.0f), 0.0f);
    EXPECT_EQ(table.at(1, 0.0f), 0.0f);
    for (float x = 1e-6f; x < 65504.0f; x *= 1.01f) {
        // The error of a linear segment over 1/128 of an octave is h²/8 times the relative curvature, which
        // is below 1/4 for these; single precision adds 1e-6.
        EXPECT_NEAR(table.at(0, x) / std::pow(x, 1.0f / 2.6f), 1.0, 1e-5) << x;
        EXPECT_NEAR(table.at(1, x) / std::pow(x, 1.0f / 2.4f), 1.0, 1e-5) << x;
        EXPECT_NEAR(table.at(2, x) / x, 1.0, 1e-5) << x;
    }
}

TEST(CurveTable, sharesARowBetweenEqualChannels) {
    const CurveTable shared([](std::span<CurveTable::Values>) {});
    EXPECT_TRUE(shared.isShared());
    std::vector<float> texels;
    EXPECT_EQ(shared.appendTo(texels), 0);
    EXPECT_EQ(shared.appendTo(texels), CurveTable::rowLength());
    EXPECT_EQ(texels.size(), 2 * 2 * std::size_t(CurveTable::rowLength()));
}

}  // namespace
}  // namespace candela
