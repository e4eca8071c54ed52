// From radiance to a displayed image: dither, exposure and sizes, through the renderer.

#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include <candela/color.h>
#include <candela/error.h>

#include <algorithm>
#include <cmath>

namespace candela::test {
namespace {

constexpr int width = 64, height = 48;

DisplayTransform transformOf(double exposure = 0.0) {
    DisplayOptions options;
    options.exposure = exposure;
    return ColorConfig::builtIn().displayTransform(options);
}

FrameRequest frame(int w = width, int h = height) {
    return {w, h, lookAt({0, 0, 3}, {0, 0, 0}, 0.5f), BrdfModel::course, Technique::fullscreen};
}

/// A surface that fills the image with one radiance.
Scene emitting(const glm::vec3& radiance) {
    Material material;
    material.emission = radiance;
    material.baseColor = {0, 0, 0, 1};
    return sceneOf(makeQuad(9.0f), material);
}

class DisplayedFrameTest : public DrawingTest {
  protected:
    static std::vector<std::uint8_t> displayed(const glm::vec3& radiance, double exposure = 0.0) {
        render(upload(emitting(radiance)), frame());
        return lastFrame().displayPicture(transformOf(exposure));
    }
};

TEST_F(DisplayedFrameTest, everyPixelIsANeighbouringCodeOfItsValue) {
    for (const float radiance : {0.001f, 0.0173f, 0.2f, 0.7f, 0.99f}) {
        std::vector<float> value{radiance, 0.5f * radiance, 0.1f * radiance, 1.0f};
        transformOf().apply(value);
        const std::vector<std::uint8_t> codes = displayed({radiance, 0.5f * radiance, 0.1f * radiance});
        for (std::size_t i = 0; i < codes.size(); ++i) {
            if (i % 4 == 3) {
                ASSERT_EQ(codes[i], 255);
                continue;
            }
            // Half a code of dither and half a code of rounding; 0.05 for the difference of GPU and CPU
            // (display_test).
            ASSERT_LT(std::abs(float(codes[i]) - 255.0f * value[i % 4]), 1.05f) << radiance;
        }
    }
}

TEST_F(DisplayedFrameTest, meanOfADimAreaIsItsValue) {
    for (const float radiance : {0.0008f, 0.003f, 0.01f}) {
        std::vector<float> value{radiance, radiance, radiance, 1.0f};
        transformOf().apply(value);
        const std::vector<std::uint8_t> codes = displayed(glm::vec3(radiance));
        double sum = 0.0;
        for (std::size_t i = 0; i < codes.size(); i += 4) sum += codes[i];
        // Codes spread by 0.5 at most: over 3,072 pixels five standard errors are 0.045; and as above.
        EXPECT_NEAR(sum / (width * height), 255.0 * value[0], 0.1) << radiance;
    }
}

TEST_F(DisplayedFrameTest, blackAndWhiteHaveNoNoise) {
    render(upload(Scene{}), frame());
    const std::vector<std::uint8_t> background = lastFrame().displayPicture(transformOf());
    const std::vector<std::uint8_t> black = displayed(glm::vec3(0)), white = displayed(glm::vec3(1000));
    for (std::size_t i = 0; i < black.size(); ++i) {
        ASSERT_EQ(black[i], i % 4 == 3 ? 255 : 0);
        ASSERT_EQ(background[i], i % 4 == 3 ? 255 : 0);
        ASSERT_EQ(white[i], 255);
    }
}

TEST_F(DisplayedFrameTest, exposureIsAFactorBeforeTheTransform) {
    for (const double stops : {-3.0, 1.0, 5.0}) {
        const auto scale = float(std::exp2(stops));
        EXPECT_EQ(displayed({0.02f, 0.01f, 0.03f}, stops),
                  displayed(scale * glm::vec3(0.02f, 0.01f, 0.03f), 0.0))
            << stops;
    }
}

TEST_F(DisplayedFrameTest, imageIsReproducible) {
    const std::vector<std::uint8_t> first = displayed({0.1f, 0.2f, 0.3f});
    EXPECT_EQ(displayed({0.1f, 0.2f, 0.3f}), first);
}

TEST_F(DisplayedFrameTest, rowsRunFromTheTop) {
    // The upper half emits.
    Material material;
    material.emission = glm::vec3(1000);
    glm::mat4 up(1.0f);
    up[3] = {0, 9, 0, 1};
    GpuScene scene = upload(sceneOf(makeQuad(9.0f), material, up));
    render(scene, frame());
    const std::vector<std::uint8_t> codes = lastFrame().displayPicture(transformOf());
    EXPECT_EQ(codes.front(), 255);
    EXPECT_EQ(codes[codes.size() - 4], 0);
    EXPECT_GT(pixelOf(lastFrame().radiance(), 3, 0).g, 1.0f);
    EXPECT_EQ(pixelOf(lastFrame().radiance(), 3, height - 1).g, 0.0f);
    EXPECT_GT(aovs(width).scalar("Z", 3, 0), 0.0f);
}

TEST_F(DisplayedFrameTest, sizesMayChangeBetweenFrames) {
    GpuScene scene = upload(emitting({0.3f, 0.3f, 0.3f}));
    for (const auto& [w, h] : {std::pair{7, 5}, {1, 1}, {130, 3}, {7, 5}}) {
        render(scene, frame(w, h));
        EXPECT_EQ(lastFrame().displayPicture(transformOf()).size(), std::size_t(4 * w * h));
        EXPECT_EQ(lastFrame().radiance().rgba.size(), std::size_t(4 * w * h));
        EXPECT_EQ(lastFrame().aovs({"Z"})[0].values[0].size(), std::size_t(w * h));
    }
}

TEST_F(DisplayedFrameTest, invalidSizesAreErrors) {
    GpuScene scene = upload(Scene{});
    for (const auto& [w, h] : {std::pair{0, 5}, {5, 0}, {-3, 4}})
        EXPECT_THROW(render(scene, frame(w, h)), Error);
    try {
        render(scene, frame(1, 1 << 20));
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::limit);
        EXPECT_NE(std::string(error.what()).find("1x1048576"), std::string::npos) << error.what();
    }
    render(scene, frame());
    EXPECT_EQ(lastFrame().radiance().width, width) << "the renderer is usable after an error";
}

TEST_F(DisplayedFrameTest, passesAreTimedInTheirOrder) {
    render(upload(emitting(glm::vec3(1))), frame());
    lastFrame().displayPicture(transformOf());
    std::vector<std::string> names;
    for (const PassTime& pass : lastFrame().passTimes()) {
        names.push_back(pass.name);
        EXPECT_GE(pass.milliseconds, 0.0);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"geometry", "lighting", "display"}));
}

}  // namespace
}  // namespace candela::test
