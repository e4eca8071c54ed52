// Pictures of many samples against closed forms and a picture of many more pixels.

#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include "render/sampling/sample_sequence.h"

#include <candela/accumulator.h>
#include <candela/sampling.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <vector>

namespace candela::test {
namespace {

constexpr double pi = std::numbers::pi;

Material unlit(const glm::vec3& color) {
    Material material;
    material.unlit = true;
    material.baseColor = glm::vec4(color, 1.0f);
    return material;
}

class SamplePictureTest : public DrawingTest {
  protected:
    static FrameSettings settingsOf(int width, int height) {
        FrameSettings settings;
        settings.width = width;
        settings.height = height;
        settings.shadows = Shadows::off;
        return settings;
    }

    /// The picture of `sampling.count` samples. `pose` brings the scene to the time of each.
    static HdrImage sampled(
        GpuScene& scene, const CameraView& view, const SamplingSettings& sampling, int width, int height,
        const std::function<void(double)>& pose = [](double) {}) {
        Accumulator accumulator(context());
        FrameSettings settings = settingsOf(width, height);
        for (std::uint32_t i = 0; i < sampling.count; ++i) {
            pose(sampleTime(0.0, sampling, i));
            settings.sample = i;
            accumulator.add(renderer().render(scene, sampleView(view, sampling, width, height, i), settings));
        }
        return accumulator.radiance();
    }

    /// Mean and variance of the place of the light in a picture of one bright spot: pixels, y down.
    struct Spot {
        double sum = 0.0;
        glm::dvec2 mean{0.0}, variance{0.0};
    };
    static Spot spotOf(const HdrImage& picture) {
        Spot spot;
        glm::dvec2 squares(0.0);
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x) {
                const double light = pixelOf(picture, x, y).r;
                const glm::dvec2 place(x + 0.5, y + 0.5);
                spot.sum += light;
                spot.mean += light * place;
                squares += light * place * place;
            }
        }
        spot.mean /= spot.sum;
        spot.variance = squares / spot.sum - spot.mean * spot.mean;
        return spot;
    }
};

/// The Blackman-Harris kernel, 1.5 pixels wide, not normalised.
double kernel(double offset) {
    if (std::abs(offset) >= 0.75) return 0.0;
    const double turn = 2.0 * pi * offset / 1.5;
    return 0.35875 + 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) + 0.01168 * std::cos(3 * turn);
}

/// The share of the kernel below an offset.
double kernelShare(double offset) {
    const double turn = 2.0 * pi / 1.5, at = std::clamp(offset, -0.75, 0.75);
    return 0.5 + (0.35875 * at + (0.48829 * std::sin(turn * at) + 0.07064 * std::sin(2.0 * turn * at) +
                                  0.01168 / 3.0 * std::sin(3.0 * turn * at)) /
                                     turn) /
                     (1.5 * 0.35875);
}

/// Mean and variance of the pixels that show bars from -`half` to `half`, each moved by one of `places`,
/// through the kernel. The kernel is narrow, so that they depend on where pixels lie.
struct Profile {
    double mean, variance;
};
Profile profileOf(double half, const std::vector<double>& places, int pixels) {
    double sum = 0.0, first = 0.0, second = 0.0;
    for (int i = 0; i < pixels; ++i) {
        const double x = i + 0.5;
        double light = 0.0;
        for (const double place : places)
            light += kernelShare(place + half - x) - kernelShare(place - half - x);
        sum += light;
        first += light * x;
        second += light * x * x;
    }
    const double mean = first / sum;
    return {mean, second / sum - mean * mean};
}

/// Evenly spread points: of a line of this length, and of a disc, seen from the side.
std::vector<double> line(double middle, double length) {
    std::vector<double> places;
    for (int i = 0; i < 500; ++i) places.push_back(middle + length * ((i + 0.5) / 500 - 0.5));
    return places;
}
std::vector<double> disc(double middle, double radius) {
    std::vector<double> places;
    for (int i = -40; i <= 40; ++i)
        for (int j = -40; j <= 40; ++j)
            if (i * i + j * j <= 40.5 * 40.5) places.push_back(middle + radius * i / 40.5);
    return places;
}

/// A tilted checker of unlit quads and balls before black: edges of all directions.
Scene edges() {
    Scene scene;
    for (std::uint32_t i = 0; i < 40; ++i) {
        const glm::vec3 color(hashed(160, i), hashed(161, i), hashed(162, i));
        const glm::vec3 center(6 * hashed(163, i) - 3, 4 * hashed(164, i) - 2, 4 * hashed(165, i) - 3);
        glm::mat4 there = glm::translate(glm::mat4(1.0f), center);
        there = glm::rotate(there, 6.0f * hashed(166, i), glm::vec3(0.2f, 0.3f, 1.0f));
        if (i % 2 == 0)
            place(scene, makeQuad(0.1f + 0.6f * hashed(167, i)), unlit(color), there);
        else
            place(scene, makeSphere(0.1f + 0.4f * hashed(168, i)), unlit(color), there);
    }
    return scene;
}

/// A picture of `factor` times as many pixels in each direction, averaged down with the kernel; what lies
/// beyond its border counts as black.
std::vector<glm::dvec3> averagedDown(const HdrImage& large, int width, int height, int factor) {
    const int reach = 3 * factor / 4;
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = -reach; i < reach; ++i) {
        weights.push_back(kernel((i + 0.5) / factor));
        sum += weights.back();
    }
    const auto at = [&](int x, int y) {
        const bool inside = x >= 0 && y >= 0 && x < large.width && y < large.height;
        return inside ? glm::dvec3(pixelOf(large, x, y)) : glm::dvec3(0.0);
    };
    std::vector<glm::dvec3> rows(std::size_t(width) * std::size_t(large.height)), result;
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < width; ++x)
            for (int i = -reach; i < reach; ++i)
                rows[std::size_t(y) * std::size_t(width) + std::size_t(x)] +=
                    weights[std::size_t(i + reach)] / sum * at(x * factor + factor / 2 + i, y);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            glm::dvec3 mean(0.0);
            for (int i = -reach; i < reach; ++i) {
                const int row = y * factor + factor / 2 + i;
                if (row < 0 || row >= large.height) continue;
                mean += weights[std::size_t(i + reach)] / sum *
                        rows[std::size_t(row) * std::size_t(width) + std::size_t(x)];
            }
            result.push_back(mean);
        }
    }
    return result;
}

TEST_F(SamplePictureTest, errorAgainstALargerPictureFallsWithTheSamples) {
    constexpr int width = 30, height = 20, factor = 64;
    GpuScene scene = upload(edges());
    const CameraView view = lookAt({0.3f, 0.2f, 7}, {0, 0, 0}, 0.7f);
    const HdrImage large =
        renderer().render(scene, view, settingsOf(factor * width, factor * height)).radiance();
    const std::vector<glm::dvec3> reference = averagedDown(large, width, height, factor);
    std::vector<double> logs;
    std::printf("RMS error against a picture of %d times as many pixels:", factor * factor);
    for (std::uint32_t count = 1; count <= 1024; count *= 4) {
        const HdrImage picture = sampled(scene, view, {.count = count}, width, height);
        double squares = 0.0, values = 0.0;
        // The larger picture ends where the filters of the outermost pixels go on.
        for (int y = 1; y < height - 1; ++y) {
            for (int x = 1; x < width - 1; ++x) {
                const glm::dvec3 off = glm::dvec3(pixelOf(picture, x, y)) -
                                       reference[std::size_t(y) * std::size_t(width) + std::size_t(x)];
                squares += glm::dot(off, off);
                values += 3.0;
            }
        }
        const double error = std::sqrt(squares / values);
        logs.push_back(std::log2(error));
        std::printf("  %u: %.5f", count, error);
    }
    // Least squares over 4 to 1024 samples, two steps of the logarithm each.
    double slope = 0.0, weight = 0.0;
    for (std::size_t i = 1; i < logs.size(); ++i) {
        const double x = 2.0 * (double(i) - 0.5 * double(logs.size()));
        slope += x * logs[i];
        weight += x * x;
    }
    slope /= weight;
    std::printf("; slope %.2f\n", slope);
    // Random samples give -0.5, stratified ones across edges -0.75 (Mitchell, "Consequences of stratified
    // sampling in graphics", 1996).
    EXPECT_LT(slope, -0.65);
    EXPECT_LT(logs.back(), std::log2(0.004));
}

TEST_F(SamplePictureTest, picturesAreNotShifted) {
    constexpr int width = 40, height = 30;
    const CameraView view = lookAt({0, 0, 5}, {0, 0, 0}, 0.6f);
    const double pixels = height / (2.0 * std::tan(0.3) * 5.0);  // a metre
    for (const glm::dvec2& at : {glm::dvec2(0.0), glm::dvec2(0.413, -0.271), glm::dvec2(-0.7, 0.55)}) {
        GpuScene scene = upload(sceneOf(makeQuad(0.25f), unlit(glm::vec3(1)),
                                        glm::translate(glm::mat4(1.0f), glm::vec3(at, 0.0))));
        const Profile x = profileOf(0.25 * pixels, {0.5 * width + pixels * at.x}, width);
        const Profile y = profileOf(0.25 * pixels, {0.5 * height - pixels * at.y}, height);
        EXPECT_NEAR(x.mean, 0.5 * width + pixels * at.x, 0.2);
        for (const std::uint32_t count : {16u, 64u, 256u, 1024u}) {
            const Spot spot = spotOf(sampled(scene, view, {.count = count}, width, height));
            // What the number of samples leaves of the edges' stairs.
            EXPECT_NEAR(spot.mean.x, x.mean, 0.7 / count + 0.004) << count;
            EXPECT_NEAR(spot.mean.y, y.mean, 0.7 / count + 0.004) << count;
        }
    }
}

TEST_F(SamplePictureTest, pointsOutOfFocusAreDiscsOfTheThinLensFormula) {
    constexpr int width = 60, height = 60;
    constexpr double focus = 3.0;
    const CameraView view = lookAt({0, 0, 0}, {0, 0, -1}, 0.5f);
    const Lens lens{0.5f, float(focus)};
    const double aperture = 0.024 / (2.0 * 0.5 * std::tan(0.25));
    EXPECT_NEAR(apertureDiameter(lens, 0.5f), aperture, 1e-6);
    for (const double distance : {1.5, 2.2, 3.0, 5.0, 20.0}) {
        const double pixels = height / (2.0 * std::tan(0.25) * distance);  // a metre at the distance
        const double side = 1.0 / pixels;                                  // half of a quad of 2 pixels
        GpuScene scene = upload(sceneOf(makeQuad(float(side)), unlit(glm::vec3(1)),
                                        glm::translate(glm::mat4(1.0f), {0, 0, float(-distance)})));
        const SamplingSettings sampling{.count = 2048, .lens = lens};
        const Spot spot = spotOf(sampled(scene, view, sampling, width, height));
        // Similar triangles: the cone from the aperture through the focus plane.
        const double radius = 0.5 * aperture * std::abs(distance - focus) / focus * pixels;
        const double expected = profileOf(1.0, disc(0.5 * width, radius), width).variance;
        EXPECT_NEAR(spot.variance.x, expected, 0.02 * expected) << distance;
        EXPECT_NEAR(spot.variance.y, expected, 0.02 * expected) << distance;
        EXPECT_NEAR(spot.sum, 4.0, 0.05) << "no light is lost";
        EXPECT_NEAR(spot.mean.x, 0.5 * width, 0.03);
        EXPECT_NEAR(spot.mean.y, 0.5 * height, 0.03);
    }
}

TEST_F(SamplePictureTest, whatMovesIsAStreakOfTheShutterInterval) {
    constexpr int width = 64, height = 24;
    constexpr float speed = 30.0f;  // metres a second to the right
    const CameraView view = lookAt({0, 0, 5}, {0, 0, 0}, 0.6f);
    const double pixels = height / (2.0 * std::tan(0.3) * 5.0);
    Scene animated = sceneOf(makeQuad(float(1.0 / pixels)), unlit(glm::vec3(1)));
    animated.nodes[0].transform = Transform{};
    animated.animations.push_back({"motion",
                                   {{.node = 0,
                                     .path = AnimationPath::translation,
                                     .times = {0.0f, 2.0f},
                                     .values = {-speed, 0, 0, speed, 0, 0}}}});
    GpuScene scene = upload(animated);
    for (const double shutter : {0.0, 0.5, 1.0}) {
        const SamplingSettings sampling{.count = 1024, .shutter = shutter, .framesPerSecond = 25.0};
        const Spot spot = spotOf(
            sampled(scene, view, sampling, width, height, [&](double time) { scene.setTime(1.0 + time); }));
        const double length = pixels * speed * shutter / 25.0;
        const double expected = profileOf(1.0, line(0.5 * width, length), width).variance;
        const double across = profileOf(1.0, {0.5 * height}, height).variance;
        EXPECT_NEAR(spot.variance.x, expected, 0.02 * expected) << shutter;
        EXPECT_NEAR(spot.variance.y, across, 0.03 * across);
        EXPECT_NEAR(spot.mean.x, 0.5 * width, 0.03) << "the picture's time is the middle of the interval";
        EXPECT_NEAR(spot.sum, 4.0, 0.05);
    }
}

TEST_F(SamplePictureTest, alphaIsTheShareOfAPixelThatASurfaceCovers) {
    constexpr int width = 20, height = 20;
    // The left edge of the quad lies in the middle of column 10.
    CameraView view;
    view.worldFromCamera[3] = {0, 0, 1, 1};
    view.orthographicHeight = 20.0f;
    GpuScene scene = upload(
        sceneOf(makeQuad(5.0f), unlit(glm::vec3(0.25f)), glm::translate(glm::mat4(1.0f), {5.5f, 0, 0})));
    const HdrImage picture = sampled(scene, view, {.count = 256}, width, height);
    const auto alpha = [&](int x) { return picture.rgba[std::size_t(4 * (10 * width + x) + 3)]; };
    EXPECT_EQ(alpha(8), 0.0f);
    EXPECT_NEAR(alpha(9), 0.0f, 0.02f);
    EXPECT_NEAR(alpha(10), 0.5f, 0.01f);
    EXPECT_NEAR(alpha(11), 1.0f, 0.02f);
    EXPECT_EQ(alpha(12), 1.0f);
    for (int x = 0; x < width - 1; ++x)
        EXPECT_NEAR(pixelOf(picture, x, 10).r, 0.25f * alpha(x), 1e-4f)
            << "radiance is associated with alpha";
}

TEST_F(SamplePictureTest, samplesAreTheSameInEachRun) {
    GpuScene scene = upload(edges());
    const CameraView view = lookAt({0.3f, 0.2f, 7}, {0, 0, 0}, 0.7f);
    const SamplingSettings sampling{.count = 8, .lens = Lens{1.0f, 7.0f}};
    EXPECT_EQ(sampled(scene, view, sampling, 32, 24).rgba, sampled(scene, view, sampling, 32, 24).rgba);
}

}  // namespace
}  // namespace candela::test
