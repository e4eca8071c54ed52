#include "../color/ramps.h"
#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "render/display/display_pass.h"

#include <candela/color.h>
#include <candela/context.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace candela {
namespace {

constexpr int width = 64;

const ColorConfig& luts() {
    static const ColorConfig config = ColorConfig::load(CANDELA_TEST_DATA "/../color/config/luts.ocio");
    return config;
}

DisplayTransform builtIn(const char* display, const char* view, double exposure = 0.0) {
    return ColorConfig::builtIn().displayTransform({display, view, "", exposure});
}

std::vector<float> filled(int height, float value) {
    return std::vector<float>(std::size_t(width) * height * 4, value);
}

/// Sends pixels through the display pass of a headless context.
class DisplayPassTest : public testing::Test {
  protected:
    std::vector<float> displayed(const std::vector<float>& rgba, const DisplayTransform& transform) {
        return drawn<float>(rgba, transform, GL_RGBA32F, GL_FLOAT);
    }

    std::vector<std::uint8_t> displayed8(const std::vector<float>& rgba, const DisplayTransform& transform) {
        return drawn<std::uint8_t>(rgba, transform, GL_RGBA8, GL_UNSIGNED_BYTE);
    }

    /// What the pass adds to each channel, measured with a grey and the identity transform.
    std::vector<float> dither(int height) {
        std::vector<float> added = displayed(filled(height, 0.5f), builtIn("sRGB", "Raw"));
        for (float& value : added) value -= 0.5f;
        return added;
    }

    /// The largest difference between the pass and OpenColorIO's CPU processor, dither taken into account.
    double worstDifference(const DisplayTransform& transform,
                           std::vector<float> radiance = test::Ramps::all()) {
        const int height = int((radiance.size() / 4 + width - 1) / width);
        radiance.resize(std::size_t(width) * height * 4, 0.0f);
        const std::vector<float> actual = displayed(radiance, transform), added = dither(height);
        std::vector<float> expected = radiance;
        transform.apply(expected);
        double worst = 0.0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            if (i % 4 == 3) continue;
            const double difference = std::abs(actual[i] - std::clamp(expected[i] + added[i], 0.0f, 1.0f));
            if (difference <= worst) continue;
            worst = difference;
            worstPixel_ = {radiance.begin() + long(i / 4 * 4), radiance.begin() + long(i / 4 * 4 + 3)};
        }
        return worst;
    }

    void expectAgreement(const ColorConfig& config, const DisplayOptions& options, double tolerance) {
        const double worst = worstDifference(config.displayTransform(options));
        EXPECT_LE(worst, tolerance) << options.display << ", " << options.view << ", look '" << options.look
                                    << "': worst at " << testing::PrintToString(worstPixel_);
    }

    void use(DisplayPass::Baking baking) { pass_ = std::make_unique<DisplayPass>(baking); }
    const DisplayPass& pass() const { return *pass_; }

  private:
    template <typename T>
    std::vector<T> drawn(const std::vector<float>& rgba, const DisplayTransform& transform, GLenum format,
                         GLenum type) {
        const int height = int(rgba.size() / 4 / width);
        const gl::Texture radiance = gl::Texture::target2d(GL_RGBA32F, width, height, "test radiance");
        glTextureSubImage2D(radiance.name(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, rgba.data());
        const gl::Texture codes = gl::Texture::target2d(format, width, height, "test codes");
        const gl::Framebuffer framebuffer({&codes}, nullptr, "test framebuffer");
        pass_->render({radiance, width, height, transform, {framebuffer.name(), 0, 0}});
        std::vector<T> result(rgba.size());
        glGetTextureImage(codes.name(), 0, GL_RGBA, type, GLsizei(result.size() * sizeof(T)), result.data());
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        return result;
    }

    Context context_ = Context::createHeadless();
    std::unique_ptr<DisplayPass> pass_ = std::make_unique<DisplayPass>();
    std::vector<float> worstPixel_;
};

// An eighth of an 8-bit code. GPUs promise powers and logarithms to some 16 units in the last place. Near
// black ACES subtracts numbers of 4e-4 and leaves an error of 4e-10 at worst, which a display of gamma 2.6
// amplifies to 2.5e-4; twice that for the other steps.
constexpr double chainRounding = 5e-4;

TEST_F(DisplayPassTest, gpuAgreesWithCpuOnEveryBuiltInView) {
    const ColorConfig config = ColorConfig::builtIn();
    for (const std::string& display : config.displays())
        for (const std::string& view : config.views(display))
            expectAgreement(config, {display, view, "", 0.0}, chainRounding);
}

TEST_F(DisplayPassTest, gpuAgreesWithCpuOnTables) {
    // GPUs may weigh the neighbours of a table's entry in steps of 1/256, half of which is the error; the
    // tables' entries lie up to 0.3 apart.
    constexpr double filtered = 0.3 / 512.0;
    for (const char* view : {"Mono", "RGB", "Tetrahedral", "Trilinear"})
        expectAgreement(luts(), {"Monitor", view, "", 0.0}, filtered);
    for (const char* look : {"warm", "faded"})
        expectAgreement(luts(), {"Monitor", "Mono", look, 0.0}, filtered);
    expectAgreement(luts(), {"Monitor", "Graded", "", 0.0}, filtered);
    // Two such errors, which the last table of the chain steepens by up to 6.6 (its first step: 0.207 over
    // 1/32).
    expectAgreement(luts(), {"Monitor", "Film and print", "", 0.0}, 2.0 * 6.6 * filtered);
}

TEST_F(DisplayPassTest, gpuAgreesWithCpuOnAnInverseTable) {
    // OpenColorIO resamples an inverse over the half floats for GPUs. Where the slope jumps by 0.1 between
    // entries, half floats 5e-4 apart miss the kink by a quarter of that: 1.2e-5.
    expectAgreement(luts(), {"Monitor", "Inverse", "", 0.0}, 5e-5);
}

TEST_F(DisplayPassTest, exposureIsTheSameOnBoth) {
    for (const double exposure : {-3.5, 2.25, 60.0, -100.0})
        EXPECT_LE(worstDifference(builtIn("sRGB", "ACES 1.0 SDR", exposure)), chainRounding)
            << exposure << " stops";
}

TEST_F(DisplayPassTest, ditherKeepsTheMeanOfLevelsBetweenCodes) {
    constexpr int height = 256;
    for (const float level : {0.2f, 10.5f, 100.75f, 254.9f}) {
        const auto codes = displayed8(filled(height, level / 255.0f), builtIn("sRGB", "Raw"));
        double sum = 0.0;
        for (std::size_t i = 0; i < codes.size(); i += 4) sum += codes[i];
        const double mean = sum / (width * height);
        // Codes spread by at most 0.5 about their mean, over 16,384 pixels: five standard errors are 0.02.
        EXPECT_NEAR(mean, level, 0.02);
    }
}

TEST_F(DisplayPassTest, valuesNearACodeBecomeThisCode) {
    constexpr int height = 256;
    for (const float level : {1.0f, 7.05f, 100.95f, 200.0f}) {
        const auto codes = displayed8(filled(height, level / 255.0f), builtIn("sRGB", "Raw"));
        const auto expected = static_cast<std::uint8_t>(std::lround(level));
        for (std::size_t i = 0; i < codes.size(); i += 4) ASSERT_EQ(codes[i], expected) << level;
    }
}

TEST_F(DisplayPassTest, blackAndWhiteHaveNoNoise) {
    for (const float level : {0.0f, 1.0f}) {
        const auto codes = displayed8(filled(64, level), builtIn("sRGB", "Un-tone-mapped"));
        for (std::size_t i = 0; i < codes.size(); ++i)
            ASSERT_EQ(codes[i], i % 4 == 3 ? 255 : level * 255) << i;
    }
}

/// The ACES views: those of the built-in config that can be baked.
std::vector<DisplayOptions> bakedOptions() {
    std::vector<DisplayOptions> baked;
    for (const std::string& display : ColorConfig::builtIn().displays())
        baked.push_back({display, "ACES 1.0 SDR", "", 0.0});
    return baked;
}

// A quarter of a code is what `BakedTransform` allows its tables; plus the rounding of the exact steps.
constexpr double bakedTolerance = 0.25 / 255.0 + chainRounding;

TEST_F(DisplayPassTest, bakedShaderAgreesWithCpu) {
    use(DisplayPass::Baking::always);
    for (const DisplayOptions& options : bakedOptions()) {
        const DisplayTransform transform = ColorConfig::builtIn().displayTransform(options);
        EXPECT_LE(worstDifference(transform), bakedTolerance) << options.display;
        EXPECT_LE(worstDifference(transform, test::Ramps().scattered(60000).rgba()), bakedTolerance)
            << options.display;
        EXPECT_TRUE(pass().isBaked(transform)) << options.display;
    }
}

TEST_F(DisplayPassTest, bakingIsLimitedToExpensiveTransforms) {
    const DisplayTransform aces = builtIn("sRGB", "ACES 1.0 SDR"), plain = builtIn("sRGB", "Un-tone-mapped"),
                           raw = builtIn("sRGB", "Raw");
    displayed(filled(16, 0.5f), aces);
    EXPECT_FALSE(pass().isBaked(aces)) << "exact by default";
    use(DisplayPass::Baking::always);
    for (const DisplayTransform& cheap : {plain, raw}) {
        displayed(filled(16, 0.5f), cheap);
        EXPECT_FALSE(pass().isBaked(cheap)) << cheap.options().view;
    }
}

TEST_F(DisplayPassTest, transformsThatDifferInExposureShareAProgram) {
    use(DisplayPass::Baking::always);
    const std::vector<float> radiance = filled(16, 0.25f);
    const DisplayTransform plain = builtIn("sRGB", "ACES 1.0 SDR"),
                           brighter = builtIn("sRGB", "ACES 1.0 SDR", 1.0);
    const std::vector<float> first = displayed(radiance, plain);
    EXPECT_NE(displayed(radiance, brighter), first);
    EXPECT_EQ(displayed(radiance, plain), first);
    EXPECT_EQ(pass().programCount(), 1u);
}

TEST_F(DisplayPassTest, transformsWithEqualTextAndOtherTablesDiffer) {
    const std::vector<float> radiance = test::Ramps::all();
    const int height = int(radiance.size() / 4 / width);
    const std::vector<float> pixels(radiance.begin(), radiance.begin() + long(height) * width * 4);
    const DisplayTransform warm = luts().displayTransform({"Monitor", "Mono", "warm", 0.0}),
                           faded = luts().displayTransform({"Monitor", "Mono", "faded", 0.0});
    const std::vector<float> first = displayed(pixels, warm);
    EXPECT_NE(displayed(pixels, faded), first);
    EXPECT_EQ(displayed(pixels, warm), first);
    EXPECT_EQ(pass().programCount(), 2u);
}

}  // namespace
}  // namespace candela
