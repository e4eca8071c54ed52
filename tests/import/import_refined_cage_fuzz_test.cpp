// Random tables from a subdivider: the host refuses them, or takes them and every index lies in its range.
// The arrays are as long as the counts say, for a plugin that lies about those can not be helped.
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

    bool oneIn(std::uint32_t chances) { return below(chances) == 0; }
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

    // The last one is right, as the entries are as many.
    std::vector<std::uint32_t> starts(std::uint32_t rows) {
        std::vector<std::uint32_t> all{0};
        for (std::uint32_t i = 0; i < rows; ++i) all.push_back(all.back() + below(4));
        if (rows > 0 && oneIn(20)) all[below(rows)] = static_cast<std::uint32_t>(random_());
        return all;
    }

  private:
    std::mt19937 random_;
};

struct FuzzedRows {
    std::vector<std::uint32_t> starts, columns;
    std::vector<float> weights, du, dv;

    FuzzedRows(TableFuzzer& fuzz, std::uint32_t rows, std::uint32_t columnCount)
        : starts(fuzz.starts(rows)),
          columns(fuzz.indices(starts.back(), columnCount)),
          weights(fuzz.weights(starts.back())),
          du(fuzz.weights(starts.back())),
          dv(fuzz.weights(starts.back())) {}

    candela_stencil_table get() const {
        return {static_cast<std::uint32_t>(starts.size() - 1),
                starts.data(),
                columns.data(),
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
    const FuzzedRows positions(fuzz, vertices, static_cast<std::uint32_t>(cage.positions.size()));
    const FuzzedRows uvs(fuzz, cage.uvs.empty() ? 0 : vertices,
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

void expectSound(const StencilTable& rows, std::size_t count, std::size_t columnCount) {
    ASSERT_EQ(rows.rowCount(), count);
    EXPECT_TRUE(std::is_sorted(rows.rowStarts.begin(), rows.rowStarts.end()));
    const std::size_t entries = rows.rowStarts.empty() ? 0 : rows.rowStarts.back();
    EXPECT_EQ(rows.columns.size(), entries);
    EXPECT_TRUE(allBelow(rows.columns, columnCount));
    for (const auto* weights : {&rows.weights, &rows.duWeights, &rows.dvWeights}) {
        EXPECT_EQ(weights->size(), entries);
        EXPECT_TRUE(std::all_of(weights->begin(), weights->end(), [](float w) { return std::isfinite(w); }));
    }
}

void expectSound(const RefinedCage& refined, const Cage& cage) {
    EXPECT_TRUE(allBelow(refined.seamPoints, refined.pointCount));
    expectSound(refined.positions, refined.vertexCount(), cage.positions.size());
    expectSound(refined.uvs, cage.uvs.empty() ? 0 : refined.vertexCount(), cage.uvs.size());
    EXPECT_EQ(refined.faceVertices.size(), refined.cageFaces.size() * refined.faceSize);
    EXPECT_TRUE(allBelow(refined.faceVertices, refined.vertexCount()));
    EXPECT_TRUE(allBelow(refined.cageFaces, cage.faceSizes.size()));
    for (const std::uint32_t hole : cage.holes)
        EXPECT_EQ(std::count(refined.cageFaces.begin(), refined.cageFaces.end(), hole), 0);
}

TEST(RefinedCageFuzz, WhatIsTakenIsSound) {
    const std::uint32_t rounds = candela_test::fuzzIterations<std::uint32_t>(20000);
    std::uint32_t taken = 0;
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        TableFuzzer fuzz(seed);
        const Cage cage = fuzzedCage(fuzz);
        try {
            expectSound(refinedFromRandom(fuzz, cage), cage);
            ++taken;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find("cage 'fuzzed': "), 0u) << error.what();
        }
    }
    // A fuzzer whose tables are nearly all refused, or nearly none, would test little.
    EXPECT_GT(taken, rounds / 5);
    EXPECT_LT(taken, rounds * 4 / 5);
}

}  // namespace
}  // namespace candela
