// The service that refines cages: its input, and the validation of its result.
#include "expect_error.h"
#include "host_calls.h"
#include "import_samples.h"

#include "import/refinement.h"

#include <candela/import.h>
#include <candela/plugin_registry.h>
#include <candela/subdivider.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace candela {
namespace {

namespace fs = std::filesystem;

const fs::path fixtures = CANDELA_TEST_FIXTURES;

Subdivider fixtureSubdivider() {
    // The registry is destroyed here; the subdivider keeps the plugin loaded.
    const auto subdivider = PluginRegistry({fixtures / "subdividers"}).subdivider();
    if (!subdivider) throw std::runtime_error("the fixture was not loaded");
    return *subdivider;
}

// The fixture selects a case by the name of the cage. Face 1 is a hole.
Cage sampleCage(const std::string& name) {
    Cage cage = importedScene([](const candela_host& host) { add(host, samples::cage()); }).cages.at(0);
    cage.name = name;
    return cage;
}

TEST(SubdividerService, IsListedByTheRegistry) {
    const PluginRegistry plugins({fixtures / "subdividers"});
    ASSERT_TRUE(plugins.subdivider());
    EXPECT_EQ(plugins.subdivider()->name(), "subdivider-cases");
    const PluginReport& report = plugins.reports().at(0);
    EXPECT_EQ(report.state, PluginState::loaded) << report.detail;
    EXPECT_TRUE(report.subdivides);
    EXPECT_TRUE(report.extensions.empty());
}

TEST(SubdividerService, IsOptional) {
    const PluginRegistry plugins({fixtures / "first"});
    const bool offered = std::any_of(plugins.reports().begin(), plugins.reports().end(),
                                     [](const PluginReport& report) { return report.subdivides; });
    EXPECT_FALSE(plugins.reports().at(0).subdivides);
    EXPECT_EQ(plugins.subdivider().has_value(), offered) << "the install folder may contain a subdivider";
}

TEST(SubdividerService, TheFirstInSearchOrderIsUsed) {
    const PluginRegistry plugins({fixtures / "other-subdividers", fixtures / "subdividers"});
    ASSERT_TRUE(plugins.subdivider());
    EXPECT_EQ(plugins.subdivider()->name(), "both");
    EXPECT_NE(plugins.importerForScheme("both"), nullptr) << "that plugin offers both services";
}

TEST(Subdivider, CopiesTheResult) {
    const RefinedCage refined = fixtureSubdivider().refine(sampleCage("good"), 3);
    EXPECT_EQ(refined.level, 3u);
    EXPECT_EQ(refined.pointCount, 6u);
    EXPECT_EQ(refined.seamPoints, std::vector<std::uint32_t>{0});
    EXPECT_EQ(refined.vertexCount(), 7u);
    EXPECT_EQ(refined.positions.offsets, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(refined.positions.controlIndices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 0}));
    EXPECT_EQ(refined.positions.weights, std::vector<float>(7, 1.0f));
    EXPECT_EQ(refined.positions.duWeights, std::vector<float>(7, 0.5f));
    EXPECT_EQ(refined.positions.dvWeights, std::vector<float>(7, 0.25f));
    EXPECT_EQ(refined.uvs.stencilCount(), 7u);
    EXPECT_EQ(refined.faceSize, 4u);
    EXPECT_EQ(refined.faceVertices, (std::vector<std::uint32_t>{0, 1, 4, 3})) << "face 1 is a hole";
    EXPECT_EQ(refined.cageFaces, std::vector<std::uint32_t>{0});
}

TEST(Subdivider, ACageWithoutTextureCoordinates) {
    Cage cage = sampleCage("good");
    cage.uvs.clear();
    cage.faceUvs.clear();
    EXPECT_EQ(fixtureSubdivider().refine(cage, 1).uvs.stencilCount(), 0u);
}

TEST(Subdivider, ConcurrentCalls) {
    const Subdivider subdivider = fixtureSubdivider();
    const std::vector<float> expected(7, 1.0f);
    std::vector<int> wrong(4, 0);
    const auto refineRepeatedly = [&](std::size_t thread) {
        const Cage cage = sampleCage("good");
        const auto level = static_cast<std::uint32_t>(1 + thread);
        for (int i = 0; i < 200; ++i) {
            const RefinedCage refined = subdivider.refine(cage, level);
            wrong[thread] += refined.level == level && refined.positions.weights == expected ? 0 : 1;
        }
    };
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < wrong.size(); ++i) threads.emplace_back(refineRepeatedly, i);
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

TEST(Subdivider, LevelsOutOfRange) {
    const Subdivider subdivider = fixtureSubdivider();
    for (const std::uint32_t level : {0u, 9u, 0xFFFFFFFFu})
        expectError([&] { subdivider.refine(sampleCage("good"), level); }, ErrorKind::badInput,
                    "cage 'good': it was to be refined to level " + std::to_string(level) +
                        ", but 1 to 8 was expected");
    EXPECT_EQ(subdivider.refine(sampleCage("good"), 8).level, 8u);
}

TEST(Subdivider, MoreCornersThan32Bits) {
    Cage cage = sampleCage("good");
    cage.holes.clear();
    cage.faceSizes.assign(16384, 4);
    cage.faceVertices.clear();
    for (int face = 0; face < 16384; ++face) cage.faceVertices.insert(cage.faceVertices.end(), {0, 1, 4, 3});
    cage.creases.clear();
    cage.faceUvs = cage.faceVertices;
    expectError([&] { fixtureSubdivider().refine(cage, 8); }, ErrorKind::limit,
                "cage 'good': at level 8 it has 4294967296 corners, more than 32 bits can count");
}

TEST(Subdivider, ACageWithoutName) {
    const std::string text =
        expectError([&] { fixtureSubdivider().refine(sampleCage(""), 1); }, ErrorKind::badInput, "");
    EXPECT_EQ(text, "cage: case: unknown");
}

// A cage that `validate` refuses is not passed to the subdivider.
TEST(Subdivider, InvalidCages) {
    const Subdivider subdivider = fixtureSubdivider();
    const auto expectRefused = [&](void (*modify)(Cage&), const char* text) {
        Cage cage = sampleCage("good");
        modify(cage);
        expectError([&] { subdivider.refine(cage, 2); }, ErrorKind::badInput, text);
    };
    expectRefused([](Cage& cage) { cage.faceVertices[5] = 6; }, "cage 'good': face 1 names vertex 6");
    expectRefused([](Cage& cage) { cage.faceVertices.pop_back(); }, "cage 'good': has 7 vertices of faces");
    expectRefused([](Cage& cage) { cage.faceUvs[0] = 99; },
                  "cage 'good': face 0 names texture coordinate 99");
    expectRefused([](Cage& cage) { cage.holes[0] = 2; }, "cage 'good': hole 0 names face 2");
    expectRefused([](Cage& cage) { cage.positions[3].y = std::numeric_limits<float>::quiet_NaN(); },
                  "cage 'good': position 3 is not a finite number");
    expectRefused([](Cage& cage) { cage.scheme = static_cast<SubdivisionScheme>(7); },
                  "cage 'good': its scheme is unknown");
}

TEST(Subdivider, MovedFrom) {
    Subdivider subdivider = fixtureSubdivider();
    const Subdivider other = std::move(subdivider);
    EXPECT_EQ(other.name(), "subdivider-cases");
    // NOLINTNEXTLINE(bugprone-use-after-move)
    expectError([&] { subdivider.refine(sampleCage("good"), 1); }, ErrorKind::badInput, "was moved from");
    expectError([&] { subdivider.name(); }, ErrorKind::badInput, "was moved from");
}

TEST(PluginRegistry, MovedFrom) {
    PluginRegistry plugins({fixtures / "subdividers"});
    const PluginRegistry other = std::move(plugins);
    EXPECT_TRUE(other.subdivider());
    // NOLINTNEXTLINE(bugprone-use-after-move)
    expectError([&] { plugins.reports(); }, ErrorKind::badInput, "was moved from");
    expectError([&] { plugins.subdivider(); }, ErrorKind::badInput, "was moved from");
    expectError([&] { plugins.importerForScheme("both"); }, ErrorKind::badInput, "was moved from");
    expectError([&] { plugins.importerForExtension("both"); }, ErrorKind::badInput, "was moved from");
    expectError([&] { importScene(plugins, "both:"); }, ErrorKind::badInput, "was moved from");
}

// The plugin in fixtures/abi_1_1 is compiled with the header of that version.
TEST(Subdivider, OfAPluginBuiltForVersion1_1) {
    const PluginRegistry plugins({fixtures / "built-for-1-1"});
    ASSERT_EQ(plugins.reports().at(0).state, PluginState::loaded) << plugins.reports()[0].detail;
    const Cage cage = sampleCage("body");
    const RefinedCage refined = plugins.subdivider().value().refine(cage, 1);
    EXPECT_EQ(refined.vertexCount(), cage.positions.size() + 1);
    EXPECT_EQ(refined.seamPoints, std::vector<std::uint32_t>{2});
    EXPECT_EQ(refined.positions.weights, std::vector<float>(refined.vertexCount(), 1.0f));
}

struct InvalidCase {
    const char* cage;
    const char* text;
    ErrorKind kind = ErrorKind::badInput;
};

class SubdividerRefuses : public testing::TestWithParam<InvalidCase> {};

TEST_P(SubdividerRefuses, AndNamesTheCage) {
    const InvalidCase& invalid = GetParam();
    const std::string name = std::string("cage '") + invalid.cage + "': ";
    const std::string text =
        expectError([&] { fixtureSubdivider().refine(sampleCage(invalid.cage), 2); }, invalid.kind, "");
    EXPECT_EQ(text, name + invalid.text);
}

TEST_P(SubdividerRefuses, AndAcceptsOtherCagesAfterwards) {
    const Subdivider subdivider = fixtureSubdivider();
    EXPECT_THROW(subdivider.refine(sampleCage(GetParam().cage), 2), Error);
    EXPECT_EQ(subdivider.refine(sampleCage("good"), 2).pointCount, 6u);
}

std::string nameOf(const testing::TestParamInfo<InvalidCase>& info) {
    std::string name = info.param.cage;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

const InvalidCase calls[] = {
    {"nothing", "the plugin 'subdivider-cases' has set no result"},
    {"twice", "the plugin 'subdivider-cases' sets more than one result"},
    {"sets-a-result-and-fails", "the plugin 'subdivider-cases' failed and gave no reason"},
    {"failed", "the plugin 'subdivider-cases' failed and gave no reason"},
    {"fails", "face 7: two of its corners are one"},
    {"fails-as-a-whole", "it is not manifold"},
    {"fails-without-reason", "edge 3-8: the plugin 'subdivider-cases' gives no reason"},
    {"throws", "the plugin 'subdivider-cases' threw an exception, which the plugin interface forbids"},
    {"fails-and-throws", "face 7: it is bad"},
    {"no-memory", "there is not enough memory to refine it to level 2", ErrorKind::limit},
};
INSTANTIATE_TEST_SUITE_P(Calls, SubdividerRefuses, testing::ValuesIn(calls), nameOf);

class TableRefused : public testing::TestWithParam<InvalidCase> {};

TEST_P(TableRefused, AndNamesPluginAndCage) {
    const InvalidCase& invalid = GetParam();
    const std::string name =
        std::string("the table of the plugin 'subdivider-cases' for cage '") + invalid.cage + "': ";
    const std::string text =
        expectError([&] { fixtureSubdivider().refine(sampleCage(invalid.cage), 2); }, invalid.kind, "");
    EXPECT_EQ(text.substr(0, text.find(", but version")), name + invalid.text);
}

const InvalidCase tables[] = {
    {"null", "it is NULL"},
    {"struct-size", "struct_size is 16"},
    {"refused-but-ok", "face_size is 2, but 3 or 4 was expected"},
    {"points", "point_count is 8, but there are 7 vertices"},
    {"seam-point", "seam_points 0 is 6, but there are 6 points"},
    {"null-seam-points", "seam_points is NULL, but 1 elements were expected"},
    {"stencil-count", "positions.stencil_count is 6, but 7 vertices need a stencil each"},
    {"null-offsets", "positions.offsets is NULL, but 8 elements were expected"},
    {"first-offset", "positions.offsets 0 is 1, but 0 was expected"},
    {"decreasing-offset", "positions.offsets 4 is 4, but no less than the one before it, 100, was expected"},
    {"control-index", "positions.control_indices 2 is 6, but there are 6 vertices of the cage"},
    {"null-control-indices", "positions.control_indices is NULL, but 7 elements were expected"},
    {"nan-weight", "positions.weights 4 has the component nan, but finite numbers were expected"},
    {"infinite-du", "positions.du_weights 5 has the component inf, but finite numbers were expected"},
    {"null-dv", "positions.dv_weights is NULL, but 7 elements were expected"},
    {"no-uvs", "uvs.stencil_count is 0, but 7 vertices need a stencil each"},
    {"uv-control-index",
     "uvs.control_indices 0 is 4294967295, but there are 6 texture coordinates of the cage"},
    {"uv-nan", "uvs.dv_weights 6 has the component nan, but finite numbers were expected"},
    {"face-size", "face_size is 5, but 3 or 4 was expected"},
    {"face-count", "it has 4294967296 corners, more than 32 bits can count", ErrorKind::limit},
    {"face-vertex", "face_vertices 3 is 7, but there are 7 vertices"},
    {"cage-face", "cage_faces 0 is 2, but there are 2 faces of the cage"},
    {"hole", "cage_faces 0 is 1, which is a hole of the cage"},
};
INSTANTIATE_TEST_SUITE_P(Tables, TableRefused, testing::ValuesIn(tables), nameOf);

TEST(Subdivider, UvStencilsWithoutTextureCoordinates) {
    Cage cage = sampleCage("uvs-of-none");
    cage.uvs.clear();
    cage.faceUvs.clear();
    expectError([&] { fixtureSubdivider().refine(cage, 1); }, ErrorKind::badInput,
                "uvs.stencil_count is 7, but the cage has no texture coordinates");
}

// The plugin receives what the importer has added, except for materials, joints and morph targets.
TEST(CageStruct, HasTheMembersOfTheCage) {
    const candela_cage source = samples::cage();
    const Cage cage = sampleCage("body");
    const CageStruct object(cage);
    const candela_cage& received = object.get();
    const auto same = [](const auto* a, const auto* b, std::size_t count) {
        return std::equal(a, a + count, b);
    };
    EXPECT_EQ(received.struct_size, sizeof received);
    EXPECT_STREQ(received.name, "body");
    ASSERT_EQ(received.vertex_count, 6u);
    EXPECT_TRUE(same(received.positions, source.positions, 18));
    ASSERT_EQ(received.face_count, 2u);
    EXPECT_TRUE(same(received.face_sizes, source.face_sizes, 2));
    EXPECT_TRUE(same(received.face_vertices, source.face_vertices, 8));
    ASSERT_EQ(received.uv_count, 6u);
    EXPECT_TRUE(same(received.uvs, source.uvs, 12));
    EXPECT_TRUE(same(received.face_uvs, source.face_uvs, 8));
    ASSERT_EQ(received.crease_count, 1u);
    EXPECT_TRUE(same(received.crease_edges, source.crease_edges, 2));
    EXPECT_EQ(received.crease_sharpness[0], 2.5f);
    ASSERT_EQ(received.corner_count, 1u);
    EXPECT_EQ(received.corner_vertices[0], 3u);
    EXPECT_EQ(received.corner_sharpness[0], 10.0f);
    ASSERT_EQ(received.hole_count, 1u);
    EXPECT_EQ(received.holes[0], 1u);
    EXPECT_EQ(received.level, 2u);
    EXPECT_EQ(received.face_materials, nullptr);
    EXPECT_EQ(received.influence_count, 0u);
    EXPECT_EQ(received.morph_target_count, 0u);
}

// Each enumerator is converted to the value that the host converts from.
TEST(CageStruct, TranslatesEveryEnumerator) {
    Cage cage = sampleCage("body");
    for (std::uint32_t i = 0; i < 3; ++i) {
        cage.scheme = static_cast<SubdivisionScheme>(i);
        cage.boundaryInterpolation = static_cast<BoundaryInterpolation>(i);
        EXPECT_EQ(CageStruct(cage).get().scheme, static_cast<candela_scheme>(i));
        EXPECT_EQ(CageStruct(cage).get().boundary_interpolation,
                  static_cast<candela_boundary_interpolation>(i));
    }
    for (std::uint32_t i = 0; i < 6; ++i) {
        cage.faceVaryingInterpolation = static_cast<FaceVaryingInterpolation>(i);
        EXPECT_EQ(CageStruct(cage).get().face_varying_interpolation,
                  static_cast<candela_face_varying_interpolation>(i));
    }
    for (std::uint32_t i = 0; i < 2; ++i) {
        cage.creaseMethod = static_cast<CreaseMethod>(i);
        cage.triangleSubdivision = static_cast<TriangleSubdivision>(i);
        EXPECT_EQ(CageStruct(cage).get().crease_method, static_cast<candela_crease_method>(i));
        EXPECT_EQ(CageStruct(cage).get().triangle_subdivision, static_cast<candela_triangle_subdivision>(i));
    }
}

}  // namespace
}  // namespace candela
