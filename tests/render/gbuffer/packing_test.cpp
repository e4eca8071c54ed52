// The G-buffer's code in C++, and the table of its channels.

#include "support/procedural_scene.h"

#include <candela/gbuffer.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace candela::test {
namespace {

double angleBetween(const glm::vec3& a, const glm::vec3& b) {
    // By the sine: the cosine of small angles has no digits left.
    return std::asin(std::min(1.0, glm::length(glm::cross(glm::dvec3(a), glm::normalize(glm::dvec3(b))))));
}

GBufferSurface roundTrip(const GBufferSurface& surface) {
    return unpackSurface(packSurface(surface));
}

TEST(Packing, normalsHaveAnErrorBelowASixteenthOfADegree) {
    // Rounding moves each coordinate on the octahedron by half a step of 1/2047 at most, and the third by
    // both: sqrt(6) / 2 steps in all, on a face that is nowhere nearer to the origin than 1 / sqrt(3).
    constexpr double bound = 0.5 * 2.4495 / 2047.0 * 1.7321 + 1.0e-6;
    double worst = 0.0, squares = 0.0;
    constexpr std::uint32_t count = 200000;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 normal = hashedDirection(20, i);
        const double angle = angleBetween(normal, roundTrip({.normal = normal}).normal);
        worst = std::max(worst, angle);
        squares += angle * angle;
    }
    std::printf("normals: largest error %.4f degrees, root mean square %.4f degrees\n",
                worst * 180.0 / std::numbers::pi, std::sqrt(squares / count) * 180.0 / std::numbers::pi);
    EXPECT_LT(worst, bound);
    EXPECT_GT(worst, 0.9 * bound) << "the bound is no wider than it has to be";
}

TEST(Packing, axesAndDiagonalsOfTheOctahedronAreExact) {
    for (const glm::vec3 normal : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0),
                                   glm::vec3(0, -1, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)}) {
        EXPECT_EQ(roundTrip({.normal = normal}).normal, normal);
    }
}

TEST(Packing, normalNeedsNoUnitLength) {
    const glm::vec3 normal(0.3f, -0.2f, -0.9f);
    EXPECT_EQ(packSurface({.normal = normal}).y, packSurface({.normal = 7.0f * normal}).y);
}

TEST(Packing, unpackedNormalsHaveUnitLength) {
    for (std::uint32_t i = 0; i < 10000; ++i) {
        const float length = glm::length(roundTrip({.normal = hashedDirection(21, i)}).normal);
        ASSERT_NEAR(length, 1.0f, 3e-7f);  // five roundings of single precision
    }
}

TEST(Packing, everyColourCodeIsPreserved) {
    for (std::uint32_t code = 0; code < 256; ++code) {
        const GBufferTexel texel{code | code << 8 | code << 16 | code << 24, 0x01800800u | code << 24};
        const GBufferTexel again = packSurface(unpackSurface(texel));
        ASSERT_EQ(again.x, texel.x);
        ASSERT_EQ(again.y, texel.y);
    }
}

TEST(Packing, valuesHaveAnErrorOfHalfACode) {
    // Half a code of 255, and the rounding of the arithmetic.
    constexpr float half = 0.5f / 255.0f + 1e-6f;
    const auto encoded = [](float linear) {
        return linear < 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
    };
    for (std::uint32_t i = 0; i <= 1000; ++i) {
        const float value = float(i) / 1000.0f;
        const GBufferSurface unpacked =
            roundTrip({.lobes = {glm::vec3(value, 0.5f, 1.0f - value), value, value}});
        ASSERT_NEAR(unpacked.lobes.metallic, value, half);
        ASSERT_NEAR(encoded(unpacked.lobes.baseColor.r), encoded(value), half);
        ASSERT_NEAR(encoded(unpacked.lobes.baseColor.b), encoded(1.0f - value), half);
    }
}

TEST(Packing, roughnessHasAnEvenRelativeError) {
    const auto unpacked = [](float roughness) {
        return roundTrip({.lobes = {.roughness = roughness}}).lobes.roughness;
    };
    EXPECT_EQ(unpacked(0.0f), 0.0f);
    EXPECT_EQ(unpacked(1.0f), 1.0f);
    const float least = std::sqrt(static_cast<float>(minAlpha));
    EXPECT_NEAR(unpacked(least), least, 1e-6f);
    EXPECT_EQ(unpacked(0.49f * least), 0.0f);
    EXPECT_NEAR(unpacked(0.51f * least), least, 1e-6f);
    for (std::uint32_t i = 0; i <= 10000; ++i) {
        const float roughness = least + (1.0f - least) * float(i) / 10000.0f;
        // Half a step of 1/254 of the fourth root's range, four times, and its square.
        const float root = std::sqrt(std::sqrt(roughness));
        const float bound = 4.0f * 0.5f * (1.0f - std::sqrt(std::sqrt(least))) / 254.0f / root * 1.01f;
        ASSERT_NEAR(unpacked(roughness) / roughness, 1.0f, bound);
    }
}

TEST(Packing, valuesBeyondTheirRangeAreClamped) {
    const GBufferSurface unpacked = roundTrip({.lobes = {{-1.0f, 2.0f, 0.0f}, 3.0f, -0.5f}});
    EXPECT_EQ(unpacked.lobes.baseColor, glm::vec3(0, 1, 0));
    EXPECT_EQ(unpacked.lobes.metallic, 1.0f);
    EXPECT_EQ(unpacked.lobes.roughness, 0.0f);
}

TEST(Packing, secondWordIsNeverZeroForASurface) {
    for (std::uint32_t i = 0; i < 100000; ++i)
        ASSERT_NE(packSurface({.normal = hashedDirection(22, i), .lobes = {.roughness = 0.0f}}).y, 0u);
    for (const float x : {-1.0f, 0.0f, 1.0f}) {
        for (const float y : {-1.0f, 0.0f, 1.0f}) {
            for (const float z : {-1.0f, 1.0f}) EXPECT_NE(packSurface({.normal = {x, y, z}}).y, 0u);
        }
    }
    EXPECT_NE(packSurface({.normal = glm::vec3(0.0f)}).y, 0u) << "a normal without length";
}

/// The rows of docs/gbuffer.md with as many cells as the channel table.
std::vector<std::vector<std::string>> documentedRows() {
    std::ifstream document(CANDELA_TEST_DATA "/../../docs/gbuffer.md");
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(document, line);) {
        if (!line.starts_with("| `")) continue;
        std::vector<std::string> cells;
        for (std::size_t at = 2; at < line.size();) {
            const std::size_t end = line.find(" |", at);
            if (end == std::string::npos) break;
            cells.push_back(line.substr(at, end - at));
            at = end + 3;
        }
        if (cells.size() == 4) rows.push_back(cells);
    }
    return rows;
}

TEST(ChannelTable, matchesTheDocumentation) {
    std::vector<std::vector<std::string>> expected;
    for (const GBufferChannel& channel : gbufferChannels())
        expected.push_back(
            {"`" + std::string(channel.name) + "`", channel.meaning, channel.encoding, channel.format});
    EXPECT_EQ(documentedRows(), expected);
}

TEST(ChannelTable, exrNamesBeginWithTheNameOfTheChannel) {
    for (const GBufferChannel& channel : gbufferChannels()) {
        const std::vector<std::string> names = exrChannelNames(channel);
        EXPECT_FALSE(names.empty());
        for (const std::string& name : names)
            EXPECT_TRUE(name == channel.name || name.starts_with(std::string(channel.name) + ".")) << name;
    }
}

}  // namespace
}  // namespace candela::test
