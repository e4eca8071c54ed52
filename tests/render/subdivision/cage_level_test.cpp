// The functions that choose the level by the size on the screen.

#include "render/subdivision/level_of_detail.h"

#include <candela/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace candela::test {
namespace {

constexpr float edgePixels = 8.0f;

TEST(CageLevelTest, edgesOfTheFirstLevelAreNoLongerThanRequested) {
    for (float longest = 0.5f; longest < 4000.0f; longest *= 1.07f) {
        const std::uint32_t level = nextLevel(std::nullopt, idealLevel(longest, edgePixels), 8);
        const float refined = longest / std::exp2(static_cast<float>(level));
        if (level < 8) {
            EXPECT_LE(refined, edgePixels * 1.00001f) << longest;
        }
        if (level > 1) {
            EXPECT_GT(2.0f * refined, edgePixels * 0.99999f)
                << "one level less would have been enough for " << longest;
        }
    }
}

TEST(CageLevelTest, staysBetweenOneAndTheMaximum) {
    const float huge = std::numeric_limits<float>::max(), none = 0.0f;
    EXPECT_EQ(nextLevel(std::nullopt, idealLevel(none, edgePixels), 5), 1u);
    EXPECT_EQ(nextLevel(3, idealLevel(none, edgePixels), 5), 1u);
    EXPECT_EQ(nextLevel(std::nullopt, idealLevel(huge, edgePixels), 5), 5u);
    EXPECT_EQ(nextLevel(5, idealLevel(huge, edgePixels), 5), 5u);
    EXPECT_EQ(nextLevel(5, 4.5f, 3), 3u) << "the maximum has been lowered";
}

TEST(CageLevelTest, smallOscillationChangesTheLevelOnceAtMost) {
    // A tenth nearer and farther is 0.14 levels each, 0.28 in all, which is little more than the hysteresis.
    for (float start = 10.0f; start < 900.0f; start *= 1.01f) {
        std::uint32_t level = nextLevel(std::nullopt, idealLevel(start, edgePixels), 8);
        int changes = 0;
        for (int step = 0; step < 200; ++step) {
            const float longest = start * (1.0f + 0.1f * std::sin(0.3f * static_cast<float>(step)));
            const std::uint32_t next = nextLevel(level, idealLevel(longest, edgePixels), 8);
            changes += next != level;
            level = next;
        }
        EXPECT_LE(changes, 1) << start;
    }
}

TEST(CageLevelTest, levelHasAHysteresisOfAQuarter) {
    EXPECT_EQ(nextLevel(3, 3.24f, 8), 3u);
    EXPECT_EQ(nextLevel(3, 3.26f, 8), 4u);
    EXPECT_EQ(nextLevel(3, 1.76f, 8), 3u);
    EXPECT_EQ(nextLevel(3, 1.74f, 8), 2u);
    EXPECT_EQ(nextLevel(3, 6.5f, 8), 7u) << "several levels at once";
}

TEST(CageLevelTest, countsRefinedPoints) {
    // Catmull-Clark cube: 8 + 12 + 6, then by Euler's formula two more than there are quads.
    const CageSize cube{8, 12, 6, 24};
    EXPECT_EQ(refinedPoints(SubdivisionScheme::catmullClark, cube, 1), 26u);
    EXPECT_EQ(refinedPoints(SubdivisionScheme::catmullClark, cube, 3), 6u * 64u + 2u);
    EXPECT_EQ(refinedPoints(SubdivisionScheme::bilinear, cube, 3), 6u * 64u + 2u);
    // A tetrahedron: a closed surface of t triangles has t / 2 + 2 vertices.
    const CageSize tetrahedron{4, 6, 4, 12};
    EXPECT_EQ(refinedPoints(SubdivisionScheme::loop, tetrahedron, 4), 4u * 256u / 2u + 2u);
}

TEST(CageLevelTest, maxVerticesBoundTheLevel) {
    const CageSize cube{8, 12, 6, 24};
    const auto levelFor = [&](std::uint32_t settingsMaxLevel, std::uint64_t maxVertices) {
        SubdivisionSettings settings;
        settings.maxLevel = settingsMaxLevel;
        settings.maxVertices = maxVertices;
        return maxLevel(SubdivisionScheme::catmullClark, cube, settings);
    };
    EXPECT_EQ(levelFor(8, 386), 3u);
    EXPECT_EQ(levelFor(8, 385), 2u);
    EXPECT_EQ(levelFor(2, 1'000'000), 2u);
    EXPECT_EQ(levelFor(8, 1), 1u) << "at least 1";
}

TEST(CageLevelTest, settingsOutOfRangeAreErrors) {
    const auto isRefused = [](const SubdivisionSettings& settings) {
        try {
            checkSettings(settings);
        } catch (const Error& error) {
            return error.kind() == ErrorKind::badInput;
        }
        return false;
    };
    EXPECT_FALSE(isRefused({}));
    for (const std::uint32_t level : {0u, 9u}) {
        SubdivisionSettings fixed, max;
        fixed.level = level;
        max.maxLevel = level;
        EXPECT_TRUE(isRefused(fixed));
        EXPECT_TRUE(isRefused(max));
    }
    SubdivisionSettings noVertices;
    noVertices.maxVertices = 0;
    EXPECT_TRUE(isRefused(noVertices));
    for (const float pixels : {0.0f, -1.0f, std::numeric_limits<float>::infinity(), std::nanf("")}) {
        SubdivisionSettings settings;
        settings.edgePixels = pixels;
        EXPECT_TRUE(isRefused(settings)) << pixels;
    }
}

/// From the origin along -Z, one pixel a metre at 100 m.
LodView hundredPixels() {
    CameraView view;
    view.verticalFov = 2.0f * std::atan(0.5f);
    view.nearPlane = 0.5f;
    return lodView(view, 100, 100);
}

TEST(EdgeLengthTest, isMeasuredInPixelsAtTheNearerEnd) {
    const std::vector<CageEdge> edge{{0, 1}};
    const std::vector<glm::vec3> across{{-0.5f, 0.0f, -10.0f}, {0.5f, 0.0f, -10.0f}};
    const float distance = std::sqrt(100.25f);
    // Roundings of a few products.
    EXPECT_NEAR(longestEdge(hundredPixels(), across, edge).value(), 100.0f / distance, 1e-4f);
    const std::vector<glm::vec3> away{{0.0f, 0.0f, -2.0f}, {0.0f, 0.0f, -5.0f}};
    EXPECT_NEAR(longestEdge(hundredPixels(), away, edge).value(), 3.0f * 100.0f / 2.0f, 1e-4f);
}

TEST(EdgeLengthTest, edgesOutOfViewAreIgnored) {
    const std::vector<glm::vec3> points{{-1, 0, -10},  {1, 0, -10}, {-50, 0, -10},
                                        {-60, 0, -10}, {0, 0, 5},   {3, 0, 5}};
    const std::vector<CageEdge> edges{{0, 1}, {2, 3}, {4, 5}};
    EXPECT_NEAR(longestEdge(hundredPixels(), points, edges).value(), 200.0f / std::sqrt(101.0f), 1e-3f);
    EXPECT_FALSE(longestEdge(hundredPixels(), points, std::vector<CageEdge>{{2, 3}, {4, 5}}));
}

TEST(EdgeLengthTest, eyeOnAnEdgeGivesAFiniteLength) {
    const std::vector<glm::vec3> points{{0, 0, 0}, {0, 0, -4}};
    EXPECT_NEAR(longestEdge(hundredPixels(), points, std::vector<CageEdge>{{0, 1}}).value(),
                4.0f * 100.0f / 0.5f, 1e-2f);
}

TEST(CageEdgesTest, eachEdgeOnceAndSeamsOnce) {
    Cage cage;
    cage.positions.resize(6);
    cage.faceSizes = {4, 4};
    cage.faceVertices = {0, 1, 4, 3, 1, 2, 5, 4};
    const std::vector<CageEdge> expected{{0, 1}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {4, 5}};
    EXPECT_EQ(edgesOf(cage), expected);
    RefinedCage refined;
    refined.pointCount = 6;
    refined.seamPoints = {1, 4};
    refined.faceVertices = {0, 1, 4, 3, 6, 2, 5, 7};
    EXPECT_EQ(edgesOf(refined), expected);
}

}  // namespace
}  // namespace candela::test
