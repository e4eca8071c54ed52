// The points of samples: stratified, in the middle first, and distributed as stated.

#include "render/sampling/sample_sequence.h"

#include <candela/error.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

namespace candela::test {
namespace {

using enum SampleDimension;
constexpr std::array dimensions{pixelX, pixelY, lensX, lensY, time, lightX, lightY, lightZ};
constexpr double pi = std::numbers::pi;

TEST(SampleSequenceTest, sampleZeroIsTheMiddle) {
    for (const SampleDimension dimension : dimensions)
        for (const std::uint32_t stream : {0u, 1u, 77u})
            EXPECT_EQ(sampleCoordinate(0, dimension, stream), 0.5);
    EXPECT_EQ(pixelOffset(0), glm::dvec2(0.0));
    EXPECT_EQ(aperturePoint(0, 0), glm::dvec2(0.0));
    EXPECT_EQ(aperturePoint(0, 5), glm::dvec2(0.0));
    EXPECT_EQ(lightPoint(0, 3), glm::dvec3(0.0));
}

TEST(SampleSequenceTest, coordinatesAreTheSameOnEveryMachine) {
    // Numerators over 2^32, written down once: a picture drawn in shards is that of one machine.
    const auto numerator = [](std::uint32_t sample, SampleDimension dimension) {
        return static_cast<std::uint64_t>(0x1p32 * sampleCoordinate(sample, dimension, 5));
    };
    EXPECT_EQ(numerator(1, pixelX), 1390000178u);
    EXPECT_EQ(numerator(2, pixelY), 1381332901u);
    EXPECT_EQ(numerator(12345, time), 1905820622u);
    EXPECT_EQ(numerator(65535, lightZ), 1782649427u);
}

/// The number of samples in each cell of a grid of columns × rows.
std::vector<int> cells(std::uint32_t first, std::uint32_t count, SampleDimension x, SampleDimension y,
                       std::uint32_t columns) {
    const std::uint32_t rows = count / columns;
    std::vector<int> result(count);
    for (std::uint32_t i = first; i < first + count; ++i) {
        const auto column = static_cast<std::size_t>(sampleCoordinate(i, x) * columns);
        const auto row = static_cast<std::size_t>(sampleCoordinate(i, y) * rows);
        ++result[row * columns + column];
    }
    return result;
}

TEST(SampleSequenceTest, blocksOfAPowerOfTwoHaveOneSampleInEachCell) {
    for (std::uint32_t count = 1; count <= 1024; count *= 2) {
        for (const std::uint32_t first : {0u, count, 37 * count}) {
            for (std::uint32_t columns = 1; columns <= count; columns *= 2)
                for (const int inCell : cells(first, count, pixelX, pixelY, columns)) ASSERT_EQ(inCell, 1);
        }
    }
    for (const SampleDimension dimension : dimensions)
        for (const int inCell : cells(0, 4096, dimension, pixelX, 4096)) ASSERT_EQ(inCell, 1);
    // Other pairs of dimensions of Sobol's sequence: four samples in each cell of four times the size, and
    // for the lens one in each of 4 × 4 of the first 16.
    for (const SampleDimension dimension : {lensX, lensY, time})
        for (const SampleDimension other : {pixelX, pixelY, lensX})
            for (const int inCell : cells(0, 256, other, dimension, other == dimension ? 256 : 16))
                ASSERT_LE(inCell, 4);
    for (const int inCell : cells(0, 16, lensX, lensY, 4)) ASSERT_EQ(inCell, 1);
}

TEST(SampleSequenceTest, coordinatesAreNotCorrelated) {
    for (const SampleDimension a : dimensions) {
        for (const SampleDimension b : dimensions) {
            if (a == b) continue;
            double sum = 0.0;
            for (std::uint32_t i = 0; i < 4096; ++i)
                sum += (sampleCoordinate(i, a, 3) - 0.5) * (sampleCoordinate(i, b, 4) - 0.5);
            EXPECT_LT(std::abs(12.0 * sum / 4096), 0.06);
        }
    }
}

TEST(SampleSequenceTest, streamsOfTheLightsDiffer) {
    std::set<double> values;
    for (std::uint32_t stream = 0; stream < 1000; ++stream)
        values.insert(sampleCoordinate(1, lightX, stream));
    EXPECT_GT(values.size(), 990u);
    EXPECT_EQ(sampleCoordinate(9, lensX, 1), sampleCoordinate(9, lensX, 2));
}

/// The largest difference between the distribution of `values` and `share(value)`.
template <typename Share>
double distance(std::vector<double> values, const Share& share) {
    std::ranges::sort(values);
    double largest = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double below = double(i) / double(values.size());
        largest = std::max(largest, std::abs(share(values[i]) - below));
    }
    return largest;
}

constexpr std::uint32_t many = 4096;
// Stratified samples are within some cells of any distribution that they follow.
constexpr double tolerance = 0.002;

TEST(SamplePointTest, offsetsOfThePixelFollowTheBlackmanHarrisKernel) {
    // The kernel, integrated numerically.
    std::vector<double> shares{0.0};
    constexpr int steps = 30000;
    for (int i = 0; i < steps; ++i) {
        const double turn = 2.0 * pi * (i + 0.5) / steps;
        shares.push_back(shares.back() + 0.35875 - 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) -
                         0.01168 * std::cos(3 * turn));
    }
    const auto share = [&](double offset) {
        return shares[std::size_t(std::lround((offset + 0.75) / 1.5 * steps))] / shares.back();
    };
    std::vector<double> x, y;
    glm::dvec2 mean(0.0);
    for (std::uint32_t i = 0; i < many; ++i) {
        const glm::dvec2 offset = pixelOffset(i);
        ASSERT_LT(std::max(std::abs(offset.x), std::abs(offset.y)), 0.75);
        x.push_back(offset.x);
        y.push_back(offset.y);
        mean += offset / double(many);
    }
    EXPECT_LT(distance(x, share), tolerance);
    EXPECT_LT(distance(y, share), tolerance);
    EXPECT_LT(glm::length(mean), 1e-3) << "the picture would be shifted";
}

TEST(SamplePointTest, aperturesAreCoveredUniformly) {
    for (const std::uint32_t blades : {0u, 3u, 5u, 6u, 64u}) {
        std::vector<double> across;
        double highest = -1.0, widest = 0.0;
        for (std::uint32_t i = 0; i < many; ++i) {
            const glm::dvec2 point = aperturePoint(i, blades);
            across.push_back(point.x);
            highest = std::max(highest, point.y);
            widest = std::max(widest, glm::length(point));
        }
        EXPECT_LE(widest, 1.0);
        EXPECT_GT(highest, blades == 0 || blades > 6 ? 0.97 : 0.9) << blades << ": a corner is at the top";
        if (blades != 0 && blades != 64) continue;
        // The share of a disc left of x.
        const auto share = [](double x) { return 0.5 + (x * std::sqrt(1.0 - x * x) + std::asin(x)) / pi; };
        EXPECT_LT(distance(across, share), 0.01) << blades;
    }
}

TEST(SamplePointTest, polygonsAreCoveredUniformly) {
    // Of a square with corners up and right, as many points lie in each of its eight octants, and a quarter
    // of them in the square of half the size.
    std::array<int, 8> octants{};
    int inner = 0;
    for (std::uint32_t i = 0; i < many; ++i) {
        const glm::dvec2 p = aperturePoint(i, 4);
        ASSERT_LE(std::abs(p.x) + std::abs(p.y), 1.0 + 1e-12);
        inner += std::abs(p.x) + std::abs(p.y) < 0.5;
        const int quadrant = (p.x < 0 ? 1 : 0) + (p.y < 0 ? 2 : 0);
        ++octants[std::size_t(2 * quadrant + (std::abs(p.x) < std::abs(p.y) ? 1 : 0))];
    }
    EXPECT_NEAR(inner, many / 4, many / 200);
    for (const int count : octants) EXPECT_NEAR(count, many / 8, many / 100);
}

TEST(SamplePointTest, lightsLookLikeEvenDiscsFromEverySide) {
    for (const glm::dvec3& way :
         {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::normalize(glm::dvec3(1, -2, 3))}) {
        const glm::dvec3 side = glm::normalize(glm::cross(way, glm::dvec3(0.3, 0.8, -0.5)));
        const glm::dvec3 up = glm::cross(way, side);
        std::vector<double> radii2, along;
        for (std::uint32_t i = 0; i < many; ++i) {
            const glm::dvec3 point = lightPoint(i, 7);
            ASSERT_LE(glm::length(point), 1.0 + 1e-12);
            const glm::dvec2 seen(glm::dot(point, side), glm::dot(point, up));
            radii2.push_back(glm::dot(seen, seen));
            along.push_back(glm::dot(point, way));
        }
        EXPECT_LT(distance(radii2, [](double r2) { return r2; }), 0.01);
        const auto share = [](double x) { return 0.5 + (x * std::sqrt(1.0 - x * x) + std::asin(x)) / pi; };
        EXPECT_LT(distance(along, share), 0.01);
    }
}

TEST(SampleViewTest, theFocusPlaneStaysWhereItIs) {
    SamplingSettings settings{.count = 64, .lens = Lens{1.4f, 3.0f, 6}};
    constexpr int width = 80, height = 60;
    const CameraView view = lookAt({1, 2, 3}, {0, 0, 0}, 0.7f);
    const glm::dmat4 frame(view.worldFromCamera);
    EXPECT_EQ(sampleView(view, settings, width, height, 0).worldFromCamera, view.worldFromCamera);
    EXPECT_EQ(sampleView(view, settings, width, height, 0).shift, view.shift);
    double widest = 0.0;
    for (std::uint32_t i = 0; i < settings.count; ++i) {
        const CameraView moved = sampleView(view, settings, width, height, i);
        for (const glm::dvec3& point : {glm::dvec3(0, 0, -3), glm::dvec3(1.2, -0.6, -3)}) {
            const auto pixel = [&](const CameraView& from) {
                const glm::dmat4 clip = glm::dmat4(projection(from, float(width) / height)) *
                                        glm::inverse(glm::dmat4(from.worldFromCamera));
                const glm::dvec4 p = clip * frame * glm::dvec4(point, 1.0);
                return glm::dvec2(p) / p.w * 0.5 * glm::dvec2(width, height);
            };
            const glm::dvec2 offset = pixel(view) - pixel(moved);
            EXPECT_NEAR(offset.x, pixelOffset(i).x, 1e-4);
            EXPECT_NEAR(offset.y, pixelOffset(i).y, 1e-4);
        }
        widest = std::max(widest, double(glm::distance(moved.eye(), view.eye())));
    }
    const float diameter = apertureDiameter(*settings.lens, view.verticalFov);
    EXPECT_NEAR(diameter, 0.024 / (2.0 * 1.4 * std::tan(0.35)), 1e-7);
    EXPECT_LE(widest, 0.5 * diameter * 1.0001);
    EXPECT_GT(widest, 0.4 * diameter);
}

TEST(SampleViewTest, timesFillTheShutterIntervalAroundThePicture) {
    const SamplingSettings settings{.count = 256, .shutter = 0.5, .framesPerSecond = 25.0};
    EXPECT_EQ(sampleTime(3.0, settings, 0), 3.0);
    std::vector<double> times;
    for (std::uint32_t i = 0; i < settings.count; ++i) times.push_back(sampleTime(3.0, settings, i) - 3.0);
    EXPECT_LT(distance(times, [](double t) { return 0.5 + t / 0.02; }), 0.01);
    EXPECT_EQ(sampleTime(3.0, SamplingSettings{}, 9), 3.0);
}

TEST(SampleViewTest, settingsOutOfTheirRangesAreRefused) {
    const auto refused = [](const SamplingSettings& settings, std::uint32_t sample = 0) {
        EXPECT_THROW(sampleView({}, settings, 8, 8, sample), Error);
        EXPECT_THROW(sampleTime(0.0, settings, sample), Error);
    };
    refused({.count = 0});
    refused({.count = maxSamples + 1});
    refused({.count = 16}, 16);
    refused({.shutter = -0.1});
    refused({.shutter = 1.1});
    refused({.shutter = std::nan("")});
    refused({.framesPerSecond = 0.0});
    for (const Lens& lens : {Lens{0.0f, 1.0f}, Lens{1.0f, 0.0f}, Lens{1.0f, -2.0f}, Lens{NAN, 1.0f},
                             Lens{1.0f, 1.0f, 2}, Lens{1.0f, 1.0f, 65}, Lens{1.0f, 1.0f, 0, 0.0f}})
        refused({.lens = lens});
    EXPECT_THROW(sampleView({}, {}, 0, 8, 0), Error);
    EXPECT_THROW(sampleTime(INFINITY, {}, 0), Error);
    CameraView flat;
    flat.orthographicHeight = 2.0f;
    EXPECT_NO_THROW(sampleView(flat, {}, 8, 8, 3));
    EXPECT_THROW(sampleView(flat, {.lens = Lens{}}, 8, 8, 3), Error);
}

}  // namespace
}  // namespace candela::test
