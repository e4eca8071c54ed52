// Random tables from a subdivider: the host refuses them, or accepts them and all indices are in range. The
// arrays have the lengths that the counts say, since the host cannot check those.
#include "import/import_refined_cage.h"
#include "support/fuzz_iterations.h"

#include <candela/error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace candela {
namespace {

class TableFuzzer {
  public:
    explicit TableFuzzer(std::uint32_t seed) : random_(seed) {}

    bool oneIn(std::uint32_t count) { return below(count) == 0; }
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(random_()) % count; }

    // Mostly below `end`.
    std::vector<std::uint32_t> indices(std::size_t count, std::uint32_t end) {
        std::vector<std::uint32_t> all(count);
        for (std::uint32_t& index : all)
            index = oneIn(300) ? static_cast<std::uint32_t>(random_()) : below(end + (oneIn(300) ? 1 : 0));
        return all;
    }

    std::vector<float> weights(std::size_t count) {
        std::vector<float> all(count);
        for (float& weight : all)
            weight = oneIn(1000) ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(below(9));
        return all;
    }

    // The last one is the number of entries.
    std::vector<std::uint32_t> offsets(std::uint32_t stencils) {
        std::vector<std::uint32_t> all{0};
        for (std::uint32_t i = 0; i < stencils; ++i) all.push_back(all.back() + below(4));
        if (stencils > 0 && oneIn(20)) all[below(stencils)] = static_cast<std::uint32_t>(random_());
        return all;
    }

  private:
    std::mt19937 random_;
};

struct FuzzedStencils {
    std::vector<std::uint32_t> offsets, controlIndices;
    std::vector<float> weights, du, dv;

    FuzzedStencils(TableFuzzer& fuzz, std::uint32_t stencils, std::uint32_t controlCount)
        : offsets(fuzz.offsets(stencils)),
          controlIndices(fuzz.indices(offsets.back(), controlCount)),
          weights(fuzz.weights(offsets.back())),
          du(fuzz.weights(offsets.back())),
          dv(fuzz.weights(offsets.back())) {}

    candela_stencil_table get() const {
        return {static_cast<std::uint32_t>(offsets.size() - 1),
                offsets.data(),
                controlIndices.data(),
                weights.data(),
                du.data(),
                dv.data()};
    }
};

Cage fuzzedCage(TableFuzzer& fuzz) {
    Cage cage;
    cage.positions.resize(1 + fuzz.below(9));
    cage.faceSizes.assign(1 + fuzz.below(5), 4);
    if (fuzz.oneIn(2)) cage.uvs.resize(1 + fuzz.below(9));
    if (fuzz.oneIn(4)) cage.holes.push_back(fuzz.below(static_cast<std::uint32_t>(cage.faceSizes.size())));
    return cage;
}

RefinedCage refinedFromRandom(TableFuzzer& fuzz, const Cage& cage) {
    const std::uint32_t points = 1 + fuzz.below(9), vertices = points + fuzz.below(4);
    const auto faces = fuzz.below(9), faceSize = fuzz.oneIn(20) ? fuzz.below(7) : 3 + fuzz.below(2);
    const auto seamPoints = fuzz.indices(vertices - points, points);
    const FuzzedStencils positions(fuzz, vertices, static_cast<std::uint32_t>(cage.positions.size()));
    const FuzzedStencils uvs(fuzz, cage.uvs.empty() ? 0 : vertices,
                             static_cast<std::uint32_t>(std::max<std::size_t>(cage.uvs.size(), 1)));
    const auto faceVertices = fuzz.indices(std::size_t{faces} * faceSize, vertices);
    const auto cageFaces = fuzz.indices(faces, static_cast<std::uint32_t>(cage.faceSizes.size()));
    candela_refined_cage result{};
    result.struct_size = sizeof result;
    result.point_count = points;
    result.vertex_count = vertices;
    result.seam_points = seamPoints.data();
    result.positions = positions.get();
    result.uvs = uvs.get();
    result.face_size = faceSize;
    result.face_count = faces;
    result.face_vertices = faceVertices.data();
    result.cage_faces = cageFaces.data();
    return refinedCageFrom(result, AbiReader("cage", std::nullopt, "fuzzed"), cage);
}

bool allBelow(const std::vector<std::uint32_t>& indices, std::size_t end) {
    return std::all_of(indices.begin(), indices.end(), [end](std::uint32_t index) { return index < end; });
}

void expectValid(const StencilTable& table, std::size_t count, std::size_t controlCount) {
    ASSERT_EQ(table.stencilCount(), count);
    EXPECT_TRUE(std::is_sorted(table.offsets.begin(), table.offsets.end()));
    const std::size_t entries = table.offsets.empty() ? 0 : table.offsets.back();
    EXPECT_EQ(table.controlIndices.size(), entries);
    EXPECT_TRUE(allBelow(table.controlIndices, controlCount));
    for (const auto* weights : {&table.weights, &table.duWeights, &table.dvWeights}) {
        EXPECT_EQ(weights->size(), entries);
        EXPECT_TRUE(std::all_of(weights->begin(), weights->end(), [](float w) { return std::isfinite(w); }));
    }
}

void expectValid(const RefinedCage& refined, const Cage& cage) {
    EXPECT_TRUE(allBelow(refined.seamPoints, refined.pointCount));
    expectValid(refined.positions, refined.vertexCount(), cage.positions.size());
    expectValid(refined.uvs, cage.uvs.empty() ? 0 : refined.vertexCount(), cage.uvs.size());
    EXPECT_EQ(refined.faceVertices.size(), refined.cageFaces.size() * refined.faceSize);
    EXPECT_TRUE(allBelow(refined.faceVertices, refined.vertexCount()));
    EXPECT_TRUE(allBelow(refined.cageFaces, cage.faceSizes.size()));
    for (const std::uint32_t hole : cage.holes)
        EXPECT_EQ(std::count(refined.cageFaces.begin(), refined.cageFaces.end(), hole), 0);
}

TEST(RefinedCageFuzz, AcceptedTablesAreValid) {
    const std::uint32_t rounds = candela_test::fuzzIterations<std::uint32_t>(20000);
    std::uint32_t accepted = 0;
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        TableFuzzer fuzz(seed);
        const Cage cage = fuzzedCage(fuzz);
        try {
            expectValid(refinedFromRandom(fuzz, cage), cage);
            ++accepted;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find("cage 'fuzzed': "), 0u) << error.what();
        }
    }
    // The tables have to exercise both outcomes.
    EXPECT_GT(accepted, rounds / 5);
    EXPECT_LT(accepted, rounds * 4 / 5);
}

}  // namespace
}  // namespace candela
