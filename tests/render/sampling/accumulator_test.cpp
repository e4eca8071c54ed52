// The mean of frames, and what of their AOVs.

#include "support/drawing_test.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"

#include <candela/accumulator.h>
#include <candela/error.h>
#include <candela/sampling.h>

#include <glm/gtc/matrix_transform.hpp>

#include <functional>
#include <string>

namespace candela::test {
namespace {

constexpr int width = 48, height = 32;

class AccumulatorTest : public DrawingTest {
  protected:
    static DisplayTransform transform() { return ColorConfig::builtIn().displayTransform({}); }

    /// Sample `i` of a picture of `count` samples.
    static Frame sample(GpuScene& scene, const CameraView& view, std::uint32_t count, std::uint32_t i) {
        FrameSettings settings;
        settings.width = width;
        settings.height = height;
        settings.shadows = Shadows::off;
        settings.sample = i;
        return renderer().render(scene, sampleView(view, {.count = count}, width, height, i), settings);
    }
};

TEST_F(AccumulatorTest, meanOfOneFrameIsTheFrame) {
    const LitScene lit = spheresOnAFloor();
    GpuScene scene = upload(lit.scene, lit.lights);
    Accumulator accumulator(context());
    const Frame frame = sample(scene, lit.view, 1, 0);
    accumulator.add(frame);
    EXPECT_EQ(accumulator.count(), 1u);
    EXPECT_EQ(accumulator.radiance().rgba, frame.radiance().rgba);
    EXPECT_EQ(accumulator.displayPicture(transform()), frame.displayPicture(transform()));
    EXPECT_EQ(accumulator.width(), width);
    EXPECT_EQ(accumulator.height(), height);
}

TEST_F(AccumulatorTest, meanIsThatOfTheFramesAndCanBeShownAtAnyTime) {
    const std::vector<WorldLight> lights{pointLight({1, 2, 3}, 20.0f, glm::vec3(5))};
    GpuScene scene = upload(sceneOf(makeSphere(1.0f), Material{}), lights);
    const CameraView view = lookAt({0, 0, 5}, {0, 0, 0}, 0.8f);
    Accumulator accumulator(context());
    constexpr std::uint32_t count = 20;
    std::vector<double> sum(std::size_t{4} * width * height);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Frame frame = sample(scene, view, count, i);
        accumulator.add(frame);
        const HdrImage radiance = frame.radiance();
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += radiance.rgba[k];
        if (i % 7 != 0 && i + 1 != count) continue;
        const HdrImage mean = accumulator.radiance();
        bool partlyCovered = false;
        for (std::size_t k = 0; k < sum.size(); ++k) {
            const double expected = sum[k] / (i + 1);
            ASSERT_NEAR(mean.rgba[k], expected, 1e-6 * expected);
            partlyCovered = partlyCovered || (k % 4 == 3 && mean.rgba[k] > 0.1f && mean.rgba[k] < 0.9f);
        }
        EXPECT_EQ(partlyCovered, i > 0) << "alpha is the coverage";
    }
    accumulator.reset();
    EXPECT_EQ(accumulator.count(), 0u);
    const Frame frame = sample(scene, view, 1, 0);
    accumulator.add(frame);
    EXPECT_EQ(accumulator.radiance().rgba, frame.radiance().rgba);
}

TEST_F(AccumulatorTest, sumsOfThousandsOfFramesKeepTheirPrecision) {
    const LitScene lit = spheresOnAFloor();
    GpuScene scene = upload(lit.scene, lit.lights);
    Accumulator accumulator(context());
    const Frame frame = sample(scene, lit.view, 1, 0);
    const HdrImage once = frame.radiance();
    for (int i = 0; i < 3000; ++i) accumulator.add(frame);
    const HdrImage mean = accumulator.radiance();
    for (std::size_t k = 0; k < mean.rgba.size(); ++k)
        ASSERT_NEAR(mean.rgba[k], once.rgba[k], 3.1e-5f * once.rgba[k]);
}

TEST_F(AccumulatorTest, samplesDrawnTogetherAreThoseDrawnOneByOne) {
    LitScene lit = spheresOnAFloor();
    constexpr std::uint32_t count = 7;
    const SamplingSettings sampling{.count = count};
    struct Case {
        const char* name;
        float radius;
        std::optional<Environment> environment;
    };
    const Environment studio = studioEnvironment();
    for (const Case& drawn : {Case{"points", 0.0f, {}}, {"spheres", 0.2f, {}}, {"studio", 0.0f, studio}}) {
        SCOPED_TRACE(drawn.name);
        for (WorldLight& light : lit.lights) light.radius = drawn.radius;
        lit.scene.environment = drawn.environment;
        GpuScene scene = upload(lit.scene, lit.lights);
        for (const Technique technique : techniques) {
            FrameSettings settings;
            settings.width = width;
            settings.height = height;
            settings.technique = technique;
            Accumulator single(context()), together(context());
            HdrImage last;
            for (settings.sample = 0; settings.sample < count; ++settings.sample) {
                const Frame frame = renderer().render(
                    scene, sampleView(lit.view, sampling, width, height, settings.sample), settings);
                single.add(frame);
                last = frame.radiance();
            }
            together.addSamples(renderer(), scene, lit.view, settings, sampling, 0, 3);
            const Frame frame =
                together.addSamples(renderer(), scene, lit.view, settings, sampling, 3, count);
            EXPECT_EQ(together.count(), count);
            const HdrImage expected = single.radiance(), mean = together.radiance();
            for (std::size_t k = 0; k < mean.rgba.size(); ++k) {
                // The sums of a pixel are rounded in another order.
                ASSERT_NEAR(mean.rgba[k], expected.rgba[k], 1e-6f * expected.rgba[k])
                    << toString(technique);
            }
            EXPECT_EQ(frame.radiance().rgba, last.rgba) << "the frame is that of the last sample";
            EXPECT_EQ(frame.technique(), technique);
            EXPECT_GT(frame.countPairs().pairsLit, 0u);
            EXPECT_FALSE(frame.passTimes().empty());
            together.add(frame);
            EXPECT_EQ(together.count(), count + 1);
        }
    }
}

TEST_F(AccumulatorTest, samplesBeyondTheCountAreRefused) {
    GpuScene scene = upload(spheresOnAFloor().scene);
    Accumulator accumulator(context());
    const CameraView view = spheresOnAFloor().view;
    const auto add = [&](std::uint32_t first, std::uint32_t end) {
        FrameSettings settings;
        settings.width = width;
        settings.height = height;
        accumulator.addSamples(renderer(), scene, view, settings, {.count = 4}, first, end);
    };
    expectRefused([&] { add(2, 2); }, "below the end");
    expectRefused([&] { add(3, 5); }, "sample 4");
    EXPECT_EQ(accumulator.count(), 0u);
    add(3, 4);
    EXPECT_EQ(accumulator.count(), 1u);
}

TEST_F(AccumulatorTest, aovsAreAveragedOrOfTheFirstSample) {
    const LitScene lit = spheresOnAFloor();
    GpuScene scene = upload(lit.scene, lit.lights);
    const std::vector<std::string> names{"Z", "N", "light_count", "P", "base_color"};
    Accumulator automatic(context(), {.aovs = names});
    Accumulator averaged(context(), {.aovs = names, .aovFilter = AovFilter::average});
    Accumulator first(context(), {.aovs = names, .aovFilter = AovFilter::first});
    constexpr std::uint32_t count = 5;
    std::vector<std::vector<Aov>> samples;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Frame frame = sample(scene, lit.view, count, i);
        for (Accumulator* accumulator : {&automatic, &averaged, &first}) accumulator->add(frame);
        samples.push_back(frame.aovs(names));
    }
    EXPECT_EQ(automatic.filterOf("Z"), AovFilter::first);
    EXPECT_EQ(automatic.filterOf("P"), AovFilter::first);
    EXPECT_EQ(automatic.filterOf("N"), AovFilter::average);
    EXPECT_EQ(averaged.filterOf("Z"), AovFilter::average);
    Accumulator none(context(), {.aovs = {"P"}});
    for (std::uint32_t i = 0; i < 2; ++i) none.add(sample(scene, lit.view, 2, i));
    EXPECT_EQ(none.aovs()[0].values, samples[0][3].values) << "no AOV is averaged";
    const std::vector<Aov> own = automatic.aovs(), mean = averaged.aovs(), one = first.aovs();
    ASSERT_EQ(own.size(), names.size());
    for (std::size_t a = 0; a < names.size(); ++a) {
        EXPECT_EQ(own[a].name, names[a]);
        EXPECT_EQ(one[a].values, samples[0][a].values);
        const bool isFirst = automatic.filterOf(names[a]) == AovFilter::first;
        EXPECT_EQ(own[a].values, isFirst ? one[a].values : mean[a].values) << names[a];
        for (std::size_t c = 0; c < mean[a].values.size(); ++c) {
            for (std::size_t i = 0; i < mean[a].values[c].size(); ++i) {
                double sum = 0.0;
                for (const std::vector<Aov>& sampled : samples) sum += sampled[a].values[c][i];
                ASSERT_NEAR(mean[a].values[c][i], sum / count, 1e-6 * (1.0 + std::abs(sum)));
            }
        }
    }
}

TEST_F(AccumulatorTest, whatItCanNotTakeIsRefused) {
    GpuScene scene = upload(spheresOnAFloor().scene);
    Accumulator accumulator(context());
    const auto draw = [&](int pixelsWide, DebugView shown = DebugView::none) {
        FrameRequest request{pixelsWide, height, spheresOnAFloor().view};
        request.debugView = shown;
        return test::render(renderer(), scene, request);
    };
    expectRefused([&] { accumulator.radiance(); }, "before a frame was added");
    expectRefused([&] { accumulator.width(); }, "before a frame was added");
    expectRefused([&] { accumulator.displayPicture(transform()); }, "before a frame was added");
    expectRefused([&] { accumulator.add(draw(width, DebugView::normals)); }, "debug view");
    accumulator.add(draw(width));
    expectRefused([&] { accumulator.add(draw(width + 1)); }, "49x32");
    EXPECT_EQ(accumulator.count(), 1u);
    accumulator.reset();
    accumulator.add(draw(width + 1));
    EXPECT_EQ(accumulator.width(), width + 1);
    const Frame old = draw(width + 1);
    draw(width + 1);
    expectRefused([&] { accumulator.add(old); }, "has drawn another one");
    expectRefused([&] { accumulator.filterOf("N"); }, "'N'");
    expectRefused([&] { Accumulator(context(), {.aovs = {"nothing"}}); }, "there is no AOV");
    const Context other = Context::createHeadless();
    Accumulator foreign(other);
    context().makeCurrent();
    const Frame frame = draw(width);
    expectRefused([&] { foreign.add(frame); }, "another Context");
    const Accumulator moved = std::move(accumulator);
    expectRefused([&] { accumulator.count(); }, "moved from");
    expectRefused([&] { moved.display(transform(), {.framebuffer = 4711}); }, "does not exist");
}

}  // namespace
}  // namespace candela::test
