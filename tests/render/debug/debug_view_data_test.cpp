// Debug views: each pixel against the value of its AOV.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"

#include <candela/color.h>
#include <candela/error.h>
#include <candela/subdivider.h>

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace candela::test {
namespace {

constexpr int width = 72, height = 50;

/// Spheres and a floor of all roughnesses under point lights, an emissive surface, an unlit one, and
/// background.
LitScene everything() {
    LitScene lit = spheresOnAFloor();
    Material emissive;
    emissive.emission = {0.02f, 0.4f, 3.0f};
    place(lit.scene, makeQuad(0.7f), emissive, glm::translate(glm::mat4(1.0f), {-2, 2, 3}));
    Material unlit;
    unlit.baseColor = {0.2f, 0.5f, 0.7f, 1};
    unlit.unlit = true;
    place(lit.scene, makeQuad(0.6f), unlit, glm::translate(glm::mat4(1.0f), {2, 2.5f, 3}));
    lit.view = lookAt({0, 1.5f, 9}, {0, 1.8f, 0}, 0.8f);
    return lit;
}

FrameRequest frameOf(const LitScene& lit, DebugView debugView = DebugView::none) {
    FrameRequest inputs{width, height, lit.view, BrdfModel::course, Technique::tiles};
    inputs.debugView = debugView;
    return inputs;
}

DisplayTransform transformOf(double exposure = 0.0) {
    DisplayOptions options;
    options.exposure = exposure;
    return ColorConfig::builtIn().displayTransform(options);
}

/// IEC 61966-2-1.
float srgb(float linear) {
    const float clamped = std::clamp(linear, 0.0f, 1.0f);
    return clamped <= 0.0031308f ? 12.92f * clamped : 1.055f * std::pow(clamped, 1.0f / 2.4f) - 0.055f;
}
glm::vec3 srgb(const glm::vec3& linear) {
    return {srgb(linear.r), srgb(linear.g), srgb(linear.b)};
}

class DebugViewDataTest : public DrawingTest {
  protected:
    void SetUp() override { scene_ = upload(lit_.scene, lit_.lights); }

    HdrImage view(DebugView debugView) { return drawn(scene_, frameOf(lit_, debugView)); }

    /// Compares the view with `expected` at the pixels with a surface, and with black at the others.
    void expectView(DebugView debugView,
                    const std::function<glm::vec3(const AovReader&, int x, int y)>& expected,
                    float tolerance) {
        const HdrImage picture = view(debugView);
        const AovReader reader = aovs(width);
        int surfaces = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const bool isSurface = reader.scalar("Z", x, y) > 0.0f;
                surfaces += isSurface;
                const glm::vec3 expectedColor = isSurface ? expected(reader, x, y) : glm::vec3(0.0f);
                const glm::vec3 off = glm::abs(pixelOf(picture, x, y) - expectedColor);
                ASSERT_LE(std::max({off.r, off.g, off.b}), isSurface ? tolerance : 0.0f)
                    << toString(debugView) << " at " << x << ", " << y;
            }
        }
        EXPECT_GT(surfaces, width * height / 2);
        EXPECT_LT(surfaces, width * height) << "there has to be a background";
    }

    LitScene lit_ = everything();
    GpuScene scene_ = upload(Scene{});
};

// The shader and C++ decode the same codes: a few roundings of numbers up to 1.
constexpr float rounding = 2e-6f;
// OpenGL's pow() may be wrong by 16 units in the last place for decoding and again for encoding.
constexpr float powerRounding = 2e-5f;

TEST_F(DebugViewDataTest, normals) {
    expectView(
        DebugView::normals,
        [](const AovReader& r, int x, int y) { return 0.5f + 0.5f * r.vector("N", x, y); }, rounding);
}

TEST_F(DebugViewDataTest, baseColor) {
    expectView(
        DebugView::baseColor,
        [](const AovReader& r, int x, int y) { return srgb(r.vector("base_color", x, y)); }, powerRounding);
}

TEST_F(DebugViewDataTest, metallicAndRoughness) {
    for (const DebugView debugView : {DebugView::metallic, DebugView::roughness}) {
        expectView(
            debugView,
            [&](const AovReader& r, int x, int y) { return glm::vec3(r.scalar(toString(debugView), x, y)); },
            rounding);
    }
}

TEST_F(DebugViewDataTest, depthIsBrightWhereItIsNear) {
    view(DebugView::depth);
    const AovReader reader = aovs(width);
    float nearest = 1e9f;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            if (reader.scalar("Z", x, y) > 0.0f) nearest = std::min(nearest, reader.scalar("Z", x, y));
    }
    expectView(
        DebugView::depth,
        [&](const AovReader& r, int x, int y) {
            return glm::vec3(nearest / (nearest + r.scalar("Z", x, y)));
        },
        rounding);
}

TEST_F(DebugViewDataTest, emission) {
    expectView(
        DebugView::emission,
        [](const AovReader& r, int x, int y) { return srgb(r.vector("emission", x, y)); }, powerRounding);
}

TEST_F(DebugViewDataTest, emissionOfASceneWithoutEmissionIsBlackAfterALitFrame) {
    const LitScene plaza = spheresOnAFloor();
    GpuScene scene = upload(plaza.scene, plaza.lights);
    drawn(scene, frameOf(plaza));
    const HdrImage picture = drawn(scene, frameOf(plaza, DebugView::emission));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) ASSERT_EQ(pixelOf(picture, x, y), glm::vec3(0.0f));
    }
}

TEST_F(DebugViewDataTest, lightCountIsAHeatMapUpToTheMaximumOfTheFrame) {
    view(DebugView::lightCount);
    const AovReader reader = aovs(width);
    float maximum = 0.0f;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) maximum = std::max(maximum, reader.scalar("light_count", x, y));
    }
    ASSERT_GT(maximum, 3.0f);
    EXPECT_EQ(lastFrame().maxLightCount(), static_cast<std::uint32_t>(maximum));
    expectView(
        DebugView::lightCount,
        [&](const AovReader& r, int x, int y) { return heatColor(r.scalar("light_count", x, y) / maximum); },
        rounding);
    view(DebugView::depth);
    EXPECT_EQ(lastFrame().maxLightCount(), 0u) << "that frame counted no lights";
}

TEST_F(DebugViewDataTest, lightCountWithoutLightsIsBlack) {
    GpuScene dark = upload(lit_.scene);
    const HdrImage picture = drawn(dark, frameOf(lit_, DebugView::lightCount));
    EXPECT_EQ(lastFrame().maxLightCount(), 0u);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) ASSERT_EQ(pixelOf(picture, x, y), glm::vec3(0.0f));
    }
}

TEST_F(DebugViewDataTest, levelOfMeshesIsGrey) {
    expectView(
        DebugView::level, [](const AovReader&, int, int) { return glm::vec3(0.5f); }, 0.0f);
}

TEST_F(DebugViewDataTest, levelOfCagesIsItsColor) {
    Scene description =
        sceneOfCage(makeSharpCubeCage(1.0f), Material{}, glm::translate(glm::mat4(1.0f), {-1.5f, 0, 0}));
    place(description, makeQuad(1.0f), Material{}, glm::translate(glm::mat4(1.0f), {1.5f, 0, 0}));
    FrameRequest inputs = frameOf(lit_, DebugView::level);
    inputs.view = lookAt({0, 0, 6}, {0, 0, 0}, 0.8f);
    const auto expectColors = [&](const GpuSceneOptions& options, std::uint32_t level) {
        GpuScene scene(context(), description, options);
        const HdrImage picture = drawn(scene, inputs);
        EXPECT_EQ(pixelOf(picture, width / 2 - 13, height / 2), levelColor(level));
        EXPECT_EQ(pixelOf(picture, width / 2 + 13, height / 2), glm::vec3(0.5f));
        EXPECT_EQ(pixelOf(picture, 1, 1), glm::vec3(0.0f));
    };
    for (const std::uint32_t level : {1u, 2u, 4u}) expectColors(subdividing(level), level);
    expectColors({}, 0);
}

TEST_F(DebugViewDataTest, emptyScenesAreBlack) {
    GpuScene empty = upload(Scene{});
    for (const DebugView debugView : debugViews()) {
        const HdrImage picture = drawn(empty, frameOf(lit_, debugView));
        for (const float value : picture.rgba) ASSERT_EQ(value, 0.0f) << toString(debugView);
    }
}

TEST_F(DebugViewDataTest, displayCopiesTheCodes) {
    for (const DebugView debugView : debugViews()) {
        const HdrImage picture = view(debugView);
        const std::vector<std::uint8_t> codes = lastFrame().displayPicture(transformOf());
        EXPECT_EQ(lastFrame().displayPicture(transformOf(3.0)), codes) << "no exposure changes it";
        for (std::size_t i = 0; i < codes.size(); ++i) {
            if (i % 4 == 3) {
                ASSERT_EQ(codes[i], 255);
                continue;
            }
            // Rounded to the nearest; OpenGL allows 0.6 codes where it asks for conversion to fixed point.
            ASSERT_NEAR(float(codes[i]), 255.0f * picture.rgba[i], 0.6f) << toString(debugView);
        }
    }
}

TEST_F(DebugViewDataTest, displayedBaseColorsAreTheCodesOfTheGBuffer) {
    Material material;
    material.baseColor = {0.25f, 0.5f, 0.75f, 1};
    LitScene lit{"", sceneOf(makeQuad(9.0f), material), {}, lookAt({0, 0, 3}, {0, 0, 0}, 0.5f)};
    drawn(upload(lit.scene), frameOf(lit, DebugView::baseColor));
    const std::vector<std::uint8_t> codes = lastFrame().displayPicture(transformOf());
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(codes[c], std::lround(255.0f * srgb(material.baseColor[int(c)])));
}

TEST_F(DebugViewDataTest, lightingIsNotRun) {
    for (const DebugView debugView : debugViews()) {
        view(debugView);
        lastFrame().displayPicture(transformOf());
        std::vector<std::string> names;
        for (const PassTime& pass : lastFrame().passTimes()) names.push_back(pass.name);
        EXPECT_EQ(names, (std::vector<std::string>{"geometry", "debug view", "display"}))
            << toString(debugView);
        EXPECT_EQ(lastFrame().technique(), Technique::tiles);
    }
}

TEST_F(DebugViewDataTest, aovsAndPairsAreThoseOfTheLitFrame) {
    drawn(scene_, frameOf(lit_));
    const std::vector<Aov> expected = lastFrame().aovs(Renderer::aovNames());
    const PairCounts pairs = lastFrame().countPairs();
    EXPECT_GT(pairs.pairsEvaluated, 0u);
    for (const DebugView debugView : debugViews()) {
        view(debugView);
        const std::vector<Aov> actual = lastFrame().aovs(Renderer::aovNames());
        for (std::size_t i = 0; i < expected.size(); ++i)
            EXPECT_EQ(actual[i].values, expected[i].values)
                << toString(debugView) << ": " << expected[i].name;
        EXPECT_EQ(lastFrame().countPairs().pairsLit, pairs.pairsLit);
        EXPECT_EQ(lastFrame().countPairs().pairsEvaluated, 0u) << "no light was evaluated";
    }
}

TEST_F(DebugViewDataTest, litFrameIsTheSameAfterADebugView) {
    for (const Technique technique : techniques) {
        FrameRequest inputs = frameOf(lit_);
        inputs.technique = technique;
        const std::vector<float> before = drawn(scene_, inputs).rgba;
        for (const DebugView debugView : debugViews()) {
            view(debugView);
            ASSERT_EQ(drawn(scene_, inputs).rgba, before)
                << toString(technique) << ", " << toString(debugView);
        }
    }
}

TEST_F(DebugViewDataTest, sizesMayChangeBetweenViews) {
    for (const auto& [w, h] : {std::pair{7, 5}, {1, 1}, {130, 3}, {7, 5}}) {
        for (const DebugView debugView : debugViews()) {
            FrameRequest inputs = frameOf(lit_, debugView);
            inputs.width = w;
            inputs.height = h;
            EXPECT_TRUE(allFinite(drawn(scene_, inputs))) << toString(debugView);
            EXPECT_EQ(lastFrame().displayPicture(transformOf()).size(), std::size_t(4 * w * h));
        }
    }
}

TEST(ColorScales, heatIsBlackBlueGreenYellowRed) {
    EXPECT_EQ(heatColor(0.0f), glm::vec3(0, 0, 0));
    EXPECT_EQ(heatColor(0.25f), glm::vec3(0, 0, 1));
    EXPECT_EQ(heatColor(0.5f), glm::vec3(0, 1, 0));
    EXPECT_EQ(heatColor(0.75f), glm::vec3(1, 1, 0));
    EXPECT_EQ(heatColor(1.0f), glm::vec3(1, 0, 0));
    EXPECT_EQ(heatColor(0.125f), glm::vec3(0, 0, 0.5f)) << "interpolated between the stops";
    EXPECT_EQ(heatColor(-1.0f), heatColor(0.0f));
    EXPECT_EQ(heatColor(7.0f), heatColor(1.0f));
    EXPECT_EQ(heatColor(std::numeric_limits<float>::quiet_NaN()), heatColor(0.0f));
}

TEST(ColorScales, levelsBeyondTheLastAreErrors) {
    EXPECT_THROW(levelColor(maxSubdivisionLevel + 1), Error);
}

TEST(ColorScales, levelsDifferClearly) {
    for (std::uint32_t a = 0; a <= maxSubdivisionLevel; ++a) {
        for (std::uint32_t b = 0; b < a; ++b) {
            const glm::vec3 off = glm::abs(levelColor(a) - levelColor(b));
            EXPECT_GT(std::max({off.r, off.g, off.b}), 0.15f) << a << " and " << b;
        }
        EXPECT_NE(levelColor(a), glm::vec3(0.5f)) << "the grey of meshes";
    }
}

TEST(ColorScales, namesAreThoseOfTheCommandLine) {
    const std::array names{"normals", "level",    "base_color",  "metallic",      "roughness",
                           "depth",   "emission", "light_count", "shadowed_count"};
    ASSERT_EQ(debugViews().size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) EXPECT_STREQ(toString(debugViews()[i]), names[i]);
    EXPECT_STREQ(toString(DebugView::none), "picture");
}

}  // namespace
}  // namespace candela::test
