#include <candela/refined_cage.h>
#include <candela/threads.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <thread>

namespace candela {
namespace {

struct Vertices {
    explicit Vertices(const RefinedCage& refined)
        : positions(refined.vertexCount()),
          normals(refined.vertexCount()),
          du(refined.vertexCount()),
          dv(refined.vertexCount()) {}
    LimitVertices all() { return {positions, normals, du, dv}; }
    bool operator==(const Vertices&) const = default;

    std::vector<glm::vec3> positions, normals, du, dv;
};

float between(std::mt19937& random, float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
}

std::uint32_t below(std::mt19937& random, std::uint32_t count) {
    return static_cast<std::uint32_t>(random()) % count;
}

StencilTable randomStencils(std::mt19937& random, std::size_t stencilCount, std::uint32_t controlCount) {
    StencilTable table;
    table.offsets.push_back(0);
    for (std::size_t stencil = 0; stencil < stencilCount; ++stencil) {
        for (std::uint32_t entry = below(random, 40); entry > 0; --entry) {
            table.controlIndices.push_back(below(random, controlCount));
            for (auto* weights : {&table.weights, &table.duWeights, &table.dvWeights})
                weights->push_back(between(random, -1.0f, 1.0f));
        }
        table.offsets.push_back(static_cast<std::uint32_t>(table.controlIndices.size()));
    }
    return table;
}

RefinedCage randomTable(std::mt19937& random, std::uint32_t pointCount, std::uint32_t seamCount,
                        std::uint32_t cagePointCount) {
    RefinedCage refined;
    refined.level = 1;
    refined.pointCount = pointCount;
    for (std::uint32_t i = 0; i < seamCount; ++i) refined.seamPoints.push_back(below(random, pointCount));
    refined.positions = randomStencils(random, refined.vertexCount(), cagePointCount);
    refined.uvs = randomStencils(random, refined.vertexCount(), cagePointCount);
    return refined;
}

std::vector<glm::vec3> randomPoints(std::mt19937& random, std::size_t count) {
    std::vector<glm::vec3> points(count);
    for (glm::vec3& point : points)
        point = {between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
    return points;
}

// Compares a sum of up to 40 products of numbers up to 1 with the sum in double precision: the error is 2^-24
// for each product, and up to 40 times that for each sum.
template <typename Vector>
void expectStencilSum(const Vector& actual, const StencilTable& table, const std::vector<float>& weights,
                      std::size_t stencil, const std::vector<Vector>& points) {
    for (glm::length_t axis = 0; axis < actual.length(); ++axis) {
        double sum = 0.0, terms = 0.0;
        for (std::size_t entry = table.offsets[stencil]; entry < table.offsets[stencil + 1]; ++entry) {
            const double term =
                static_cast<double>(weights[entry]) * points[table.controlIndices[entry]][axis];
            sum += term;
            terms += std::abs(term);
        }
        const double roundings = table.offsets[stencil + 1] - table.offsets[stencil] + 1;
        EXPECT_NEAR(actual[axis], sum, roundings * terms * 0x1p-24) << "stencil " << stencil;
    }
}

// A table with one stencil whose derivatives are `du` and `dv`.
Vertices evaluateTangents(const glm::vec3& du, const glm::vec3& dv) {
    RefinedCage refined;
    refined.pointCount = 1;
    refined.positions = {{0, 2}, {0, 1}, {1, 0}, {1, 0}, {0, 1}};
    Vertices vertices(refined);
    evaluateLimit(refined, std::vector{du, dv}, vertices.all());
    return vertices;
}

TEST(LimitEvaluation, IsTheTableTimesThePoints) {
    std::mt19937 random(1);
    const RefinedCage refined = randomTable(random, 6000, 1000, 300);
    const std::vector<glm::vec3> points = randomPoints(random, 300);
    Vertices vertices(refined);
    evaluateLimit(refined, points, vertices.all());
    const StencilTable& table = refined.positions;
    for (std::size_t stencil = 0; stencil < refined.vertexCount(); ++stencil) {
        if (stencil < refined.pointCount)
            expectStencilSum(vertices.positions[stencil], table, table.weights, stencil, points);
        expectStencilSum(vertices.du[stencil], table, table.duWeights, stencil, points);
        expectStencilSum(vertices.dv[stencil], table, table.dvWeights, stencil, points);
        const glm::dvec3 cross =
            glm::cross(glm::dvec3(vertices.du[stencil]), glm::dvec3(vertices.dv[stencil]));
        const glm::dvec3 expected = cross == glm::dvec3(0.0) ? cross : glm::normalize(cross);
        // The cross product is rounded relative to the product of the lengths, so that its relative error is
        // larger for smaller angles.
        const double lengths = glm::length(vertices.du[stencil]) * glm::length(vertices.dv[stencil]);
        const double tolerance = 3e-7 * (1.0 + (lengths > 0.0 ? lengths / glm::length(cross) : 0.0));
        EXPECT_LE(glm::distance(glm::dvec3(vertices.normals[stencil]), expected), tolerance)
            << "stencil " << stencil;
    }
}

TEST(LimitEvaluation, PlacesSeamVerticesAtTheirPoint) {
    std::mt19937 random(2);
    const RefinedCage refined = randomTable(random, 4000, 4000, 100);
    Vertices vertices(refined);
    evaluateLimit(refined, randomPoints(random, 100), vertices.all());
    for (std::uint32_t vertex = refined.pointCount; vertex < refined.vertexCount(); ++vertex)
        ASSERT_EQ(vertices.positions[vertex], vertices.positions[refined.pointOf(vertex)]) << vertex;
}

TEST(LimitEvaluation, OmitsDerivativesThatAreNotRequested) {
    std::mt19937 random(3);
    const RefinedCage refined = randomTable(random, 3000, 500, 100);
    const std::vector<glm::vec3> points = randomPoints(random, 100);
    Vertices all(refined), without(refined), onlyDv(refined);
    evaluateLimit(refined, points, all.all());
    evaluateLimit(refined, points, {without.positions, without.normals, {}, {}});
    EXPECT_EQ(without.positions, all.positions);
    EXPECT_EQ(without.normals, all.normals);
    evaluateLimit(refined, points, {onlyDv.positions, onlyDv.normals, {}, onlyDv.dv});
    EXPECT_EQ(onlyDv.normals, all.normals);
    EXPECT_EQ(onlyDv.dv, all.dv);
}

TEST(LimitEvaluation, DoesNotDependOnTheNumberOfThreads) {
    std::mt19937 random(4);
    const RefinedCage refined = randomTable(random, 20'000, 5000, 1000);
    const std::vector<glm::vec3> points = randomPoints(random, 1000);
    Vertices shared(refined);
    evaluateLimit(refined, points, shared.all());
    for (const unsigned size : {1u, 2u, 3u, 8u}) {
        setThreadCount(size);
        Vertices vertices(refined);
        evaluateLimit(refined, points, vertices.all());
        EXPECT_TRUE(vertices == shared) << size << " threads";
    }
    setThreadCount(0);
}

TEST(LimitEvaluation, MayBeCalledFromSeveralThreads) {
    std::mt19937 random(5);
    const RefinedCage refined = randomTable(random, 10'000, 1000, 500);
    const std::vector<glm::vec3> points = randomPoints(random, 500);
    Vertices expected(refined);
    evaluateLimit(refined, points, expected.all());
    std::vector<Vertices> results(4, Vertices(refined));
    std::vector<std::thread> threads;
    for (Vertices& result : results) {
        threads.emplace_back([&] {
            for (int round = 0; round < 20; ++round) evaluateLimit(refined, points, result.all());
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const Vertices& result : results) EXPECT_TRUE(result == expected);
}

TEST(LimitEvaluation, HasUnitNormalsAtEveryScale) {
    for (const float u : {1e-38f, 1e-20f, 1e-5f, 1.0f, 1e15f, 1e38f}) {
        for (const float v : {1e-38f, 1e-20f, 1e-5f, 1.0f, 1e15f, 1e38f}) {
            const Vertices vertices = evaluateTangents({u, u, 0}, {0, v, v});
            const float third = std::sqrt(1.0f / 3.0f);
            // A few roundings of a component.
            EXPECT_LE(glm::distance(vertices.normals[0], glm::vec3(third, -third, third)), 3e-7f)
                << u << " " << v;
        }
    }
}

TEST(LimitEvaluation, HasNoNormalForDegenerateTangents) {
    const glm::vec3 none(0.0f), x(1, 0, 0);
    EXPECT_EQ(evaluateTangents(none, none).normals[0], none);
    EXPECT_EQ(evaluateTangents(x, none).normals[0], none);
    EXPECT_EQ(evaluateTangents(x, 3.0f * x).normals[0], none);
    EXPECT_EQ(evaluateTangents(glm::vec3(INFINITY, 0, 0), {0, 1, 0}).normals[0], none);
}

TEST(LimitEvaluation, OfStencilsWithoutEntriesIsZero) {
    RefinedCage refined;
    refined.pointCount = 2;
    refined.positions.offsets = {0, 0, 0};
    Vertices vertices(refined);
    vertices.positions.assign(2, glm::vec3(7));
    evaluateLimit(refined, {}, vertices.all());
    EXPECT_EQ(vertices.positions[1], glm::vec3(0));
    EXPECT_EQ(vertices.normals[1], glm::vec3(0));
}

TEST(LimitEvaluation, OfAnEmptyTable) {
    const RefinedCage refined;
    evaluateLimit(refined, {}, {});
    EXPECT_TRUE(evaluateLimitUvs(refined, {}).uvs.empty());
}

TEST(LimitUvs, AreTheTableTimesTheTextureCoordinates) {
    std::mt19937 random(6);
    const RefinedCage refined = randomTable(random, 6000, 1000, 300);
    std::vector<glm::vec2> points(300);
    for (glm::vec2& point : points) point = {between(random, 0, 1), between(random, 0, 1)};
    const LimitUvs uvs = evaluateLimitUvs(refined, points);
    const StencilTable& table = refined.uvs;
    ASSERT_EQ(uvs.uvs.size(), refined.vertexCount());
    ASSERT_EQ(uvs.du.size(), refined.vertexCount());
    ASSERT_EQ(uvs.dv.size(), refined.vertexCount());
    for (std::size_t stencil = 0; stencil < refined.vertexCount(); ++stencil) {
        expectStencilSum(uvs.uvs[stencil], table, table.weights, stencil, points);
        expectStencilSum(uvs.du[stencil], table, table.duWeights, stencil, points);
        expectStencilSum(uvs.dv[stencil], table, table.dvWeights, stencil, points);
    }
}

}  // namespace
}  // namespace candela
