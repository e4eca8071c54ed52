// What the host accepts and refuses of cages, of skins and of cage instances.
#include "expect_error.h"
#include "host_calls.h"
#include "import_samples.h"

#include <candela/scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <string>

namespace candela {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

// Sets an enumeration to any number.
template <class Enum>
void setNumber(Enum& to, std::uint32_t number) {
    static_assert(sizeof to == sizeof number);
    std::memcpy(&to, &number, sizeof number);
}

using ModifyCage = std::function<void(candela_cage&)>;

void expectCageRefused(const ModifyCage& modify, const std::string& text,
                       ErrorKind kind = ErrorKind::badInput) {
    const auto importElement = [&] {
        importedScene([&](const candela_host& host) { add(host, modified(samples::cage(), modify)); });
    };
    EXPECT_EQ(expectError(importElement, kind, ""), "test: cage 0 'body': " + text);
}

TEST(HostCage, CopiesWhatIsAdded) {
    const Scene scene = importedScene([](const candela_host& host) { add(host, samples::cage()); });
    const Cage& cage = scene.cages.at(0);
    EXPECT_EQ(cage.name, "body");
    EXPECT_EQ(cage.scheme, SubdivisionScheme::catmullClark);
    EXPECT_EQ(cage.boundaryInterpolation, BoundaryInterpolation::edgesAndCorners);
    EXPECT_EQ(cage.faceVaryingInterpolation, FaceVaryingInterpolation::cornersOnly);
    ASSERT_EQ(cage.positions.size(), 6u);
    EXPECT_EQ(cage.positions[5], glm::vec3(2, 1, 0));
    EXPECT_EQ(cage.faceSizes, (std::vector<std::uint32_t>{4, 4}));
    EXPECT_EQ(cage.faceVertices, (std::vector<std::uint32_t>{0, 1, 4, 3, 1, 2, 5, 4}));
    ASSERT_EQ(cage.uvs.size(), 6u);
    EXPECT_EQ(cage.uvs[4], glm::vec2(1, 1));
    EXPECT_EQ(cage.faceUvs, cage.faceVertices);
    ASSERT_EQ(cage.creases.size(), 1u);
    EXPECT_EQ(cage.creases[0].vertex0, 1u);
    EXPECT_EQ(cage.creases[0].vertex1, 4u);
    EXPECT_EQ(cage.creases[0].sharpness, 2.5f);
    ASSERT_EQ(cage.corners.size(), 1u);
    EXPECT_EQ(cage.corners[0].vertex, 3u);
    EXPECT_EQ(cage.corners[0].sharpness, infiniteSharpness);
    EXPECT_EQ(cage.holes, std::vector<std::uint32_t>{1});
    EXPECT_TRUE(cage.faceMaterials.empty());
    EXPECT_EQ(cage.level, 2u);
    EXPECT_EQ(cage.joints.size(), 12u);
    ASSERT_EQ(cage.morphTargets.size(), 2u);
    EXPECT_EQ(cage.morphTargets[0].offsets.at(0), glm::vec3(1, 2, 3));
    EXPECT_EQ(cage.morphTargets[1].offsets.at(0), glm::vec3(0));
}

TEST(HostCage, EnumeratorsAreTranslated) {
    const auto cageOf = [](const ModifyCage& modify) {
        return importedScene([&](const candela_host& host) { add(host, modified(samples::cage(), modify)); })
            .cages.at(0);
    };
    const Cage cage = cageOf([](candela_cage& c) {
        c.scheme = CANDELA_SCHEME_BILINEAR;
        c.boundary_interpolation = CANDELA_BOUNDARY_NONE;
        c.face_varying_interpolation = CANDELA_FACE_VARYING_ALL;
        c.crease_method = CANDELA_CREASE_CHAIKIN;
        c.triangle_subdivision = CANDELA_TRIANGLE_SMOOTH;
        c.level = 0;
    });
    EXPECT_EQ(cage.scheme, SubdivisionScheme::bilinear);
    EXPECT_EQ(cage.boundaryInterpolation, BoundaryInterpolation::none);
    EXPECT_EQ(cage.faceVaryingInterpolation, FaceVaryingInterpolation::all);
    EXPECT_EQ(cage.creaseMethod, CreaseMethod::chaikin);
    EXPECT_EQ(cage.triangleSubdivision, TriangleSubdivision::smooth);
    EXPECT_FALSE(cage.level);
    const Cage other = cageOf([](candela_cage& c) {
        c.scheme = CANDELA_SCHEME_LOOP;
        c.boundary_interpolation = CANDELA_BOUNDARY_EDGES;
        c.face_varying_interpolation = CANDELA_FACE_VARYING_CORNERS_PLUS2;
    });
    EXPECT_EQ(other.scheme, SubdivisionScheme::loop);
    EXPECT_EQ(other.boundaryInterpolation, BoundaryInterpolation::edges);
    EXPECT_EQ(other.faceVaryingInterpolation, FaceVaryingInterpolation::cornersPlus2);
}

TEST(HostCage, JointWeightsAreNormalized) {
    const Scene scene = importedScene([](const candela_host& host) { add(host, samples::cage()); });
    const std::vector<float>& weights = scene.cages.at(0).jointWeights;
    // 1 and 3 of a sum of 4: exact in single precision.
    EXPECT_EQ(weights.at(2), 0.25f);
    EXPECT_EQ(weights.at(3), 0.75f);
    EXPECT_EQ(weights.at(4), 0.0f);
    EXPECT_EQ(weights.at(5), 1.0f);
}

TEST(HostCage, MaterialsOfFaces) {
    candela_material material = samples::material();
    const std::int32_t materials[] = {-1, 0};
    const Scene scene = importedScene([&](const candela_host& host) {
        host.add_material(host.self, &material);
        add(host, modified(samples::cage(), [&](candela_cage& c) { c.face_materials = materials; }));
    });
    ASSERT_EQ(scene.cages.at(0).faceMaterials.size(), 2u);
    EXPECT_FALSE(scene.cages[0].faceMaterials[0]);
    EXPECT_EQ(scene.cages[0].faceMaterials[1], 0u);
    const std::int32_t later[] = {-1, 3};
    expectCageRefused([&](candela_cage& c) { c.face_materials = later; },
                      "face 1: material is 3, but 0 were added so far and -1 is none");
    const std::int32_t negative[] = {-2, -1};
    expectCageRefused([&](candela_cage& c) { c.face_materials = negative; },
                      "face 0: material is -2, but 0 were added so far and -1 is none");
}

TEST(HostCageRefuses, UnknownRules) {
    expectCageRefused([](candela_cage& c) { setNumber(c.scheme, 3); },
                      "scheme is 3, but 0 to 2 was expected");
    expectCageRefused([](candela_cage& c) { setNumber(c.boundary_interpolation, 3); },
                      "boundary_interpolation is 3, but 0 to 2 was expected");
    expectCageRefused([](candela_cage& c) { setNumber(c.face_varying_interpolation, 6); },
                      "face_varying_interpolation is 6, but 0 to 5 was expected");
    expectCageRefused([](candela_cage& c) { setNumber(c.crease_method, 2); },
                      "crease_method is 2, but 0 to 1 was expected");
    expectCageRefused([](candela_cage& c) { setNumber(c.triangle_subdivision, 0xFFFFFFFF); },
                      "triangle_subdivision is -1, but 0 to 1 was expected");
    expectCageRefused([](candela_cage& c) { c.level = 9; }, "level is 9, but 0 to 8 was expected");
}

TEST(HostCageRefuses, MissingArrays) {
    expectCageRefused([](candela_cage& c) { c.positions = nullptr; },
                      "position is NULL, but 6 elements were expected");
    expectCageRefused([](candela_cage& c) { c.face_sizes = nullptr; },
                      "face_sizes is NULL, but 2 elements were expected");
    expectCageRefused([](candela_cage& c) { c.face_vertices = nullptr; },
                      "face_vertices is NULL, but 8 elements were expected");
    expectCageRefused([](candela_cage& c) { c.uvs = nullptr; }, "uv is NULL, but 6 elements were expected");
    expectCageRefused([](candela_cage& c) { c.face_uvs = nullptr; },
                      "face_uvs is NULL, but 8 elements were expected");
    expectCageRefused([](candela_cage& c) { c.crease_edges = nullptr; },
                      "crease_edges is NULL, but 2 elements were expected");
    expectCageRefused([](candela_cage& c) { c.crease_sharpness = nullptr; },
                      "crease_sharpness is NULL, but 1 elements were expected");
    expectCageRefused([](candela_cage& c) { c.corner_vertices = nullptr; },
                      "corner_vertices is NULL, but 1 elements were expected");
    expectCageRefused([](candela_cage& c) { c.corner_sharpness = nullptr; },
                      "corner_sharpness is NULL, but 1 elements were expected");
    expectCageRefused([](candela_cage& c) { c.holes = nullptr; },
                      "holes is NULL, but 1 elements were expected");
    expectCageRefused([](candela_cage& c) { c.joints = nullptr; },
                      "joints is NULL, but 12 elements were expected");
    expectCageRefused([](candela_cage& c) { c.joint_weights = nullptr; },
                      "joint_weight is NULL, but 12 elements were expected");
    expectCageRefused([](candela_cage& c) { c.morph_offsets = nullptr; },
                      "morph_offsets is NULL, but morph_target_count is 2");
}

TEST(HostCageRefuses, Faces) {
    const std::uint32_t two[] = {4, 2};
    expectCageRefused([&](candela_cage& c) { c.face_sizes = two; },
                      "face 1 has 2 corners, but 3 to 6, the number of vertices, were expected");
    const std::uint32_t seven[] = {7, 4};
    expectCageRefused([&](candela_cage& c) { c.face_sizes = seven; },
                      "face 0 has 7 corners, but 3 to 6, the number of vertices, were expected");
    // Their sum is 0 modulo 2^32.
    const std::uint32_t overflowing[] = {0x80000000, 0x80000000};
    expectCageRefused([&](candela_cage& c) { c.face_sizes = overflowing; },
                      "face 0 has 2147483648 corners, but 3 to 6, the number of vertices, were expected");
    auto vertices = samples::faceVertices;
    vertices[6] = 6;
    expectCageRefused([&](candela_cage& c) { c.face_vertices = vertices.data(); },
                      "face 1: corner 2 has vertex 6, but there are 6");
    vertices[6] = 0xFFFFFFFF;
    expectCageRefused([&](candela_cage& c) { c.face_uvs = vertices.data(); },
                      "face 1: corner 2 has uv 4294967295, but there are 6");
    const std::uint32_t hole = 2;
    expectCageRefused([&](candela_cage& c) { c.holes = &hole; }, "hole 0 is face 2, but there are 2");
}

TEST(HostCageRefuses, Sharpness) {
    const std::uint32_t edge[] = {1, 6};
    expectCageRefused([&](candela_cage& c) { c.crease_edges = edge; },
                      "crease 0 names vertex 6, but there are 6");
    const float negative = -0.5f;
    expectCageRefused([&](candela_cage& c) { c.crease_sharpness = &negative; },
                      "edge 1-4: its sharpness is -0.5, but 0 or more was expected");
    expectCageRefused([&](candela_cage& c) { c.crease_sharpness = &nan; },
                      "crease_sharpness 0 has the component nan, but finite numbers were expected");
    const std::uint32_t vertex = 9;
    expectCageRefused([&](candela_cage& c) { c.corner_vertices = &vertex; },
                      "corner 0 names vertex 9, but there are 6");
    expectCageRefused([&](candela_cage& c) { c.corner_sharpness = &negative; },
                      "vertex 3: its sharpness is -0.5, but 0 or more was expected");
    expectCageRefused([&](candela_cage& c) { c.corner_sharpness = &nan; },
                      "corner_sharpness 0 has the component nan, but finite numbers were expected");
}

TEST(HostCageRefuses, NumbersThatAreNotFinite) {
    auto positions = samples::cagePositions;
    positions[7] = nan;
    expectCageRefused([&](candela_cage& c) { c.positions = positions.data(); },
                      "position 2 has the component nan, but finite numbers were expected");
    auto uvs = samples::cageUvs;
    uvs[11] = -std::numeric_limits<float>::infinity();
    expectCageRefused([&](candela_cage& c) { c.uvs = uvs.data(); },
                      "uv 5 has the component -inf, but finite numbers were expected");
    auto offsets = samples::morphOffsets;
    offsets[35] = nan;
    expectCageRefused([&](candela_cage& c) { c.morph_offsets = offsets.data(); },
                      "morph target 1: offset 5 has the component nan, but finite numbers were expected");
}

TEST(HostCageRefuses, JointWeights) {
    auto weights = samples::jointWeights;
    weights[3] = -1.0f;
    expectCageRefused([&](candela_cage& c) { c.joint_weights = weights.data(); },
                      "vertex 1 has the joint weight -1, but 0 or more was expected");
    weights[2] = weights[3] = 0.0f;
    expectCageRefused([&](candela_cage& c) { c.joint_weights = weights.data(); },
                      "vertex 1 has joint weights that are all 0");
}

TEST(HostCageRefuses, MorphTargetsWithoutVertices) {
    expectCageRefused(
        [](candela_cage& c) {
            c = {};
            c.struct_size = sizeof c;
            c.name = "body";
            c.morph_target_count = 0xFFFFFFFF;
            c.morph_offsets = samples::morphOffsets.data();
        },
        "morph_target_count is 4294967295, but there are no vertices to move");
}

TEST(HostCageRefuses, NullAndTooSmallStructs) {
    const auto refused = [](const std::function<void(const candela_host&)>& addElements, const char* text) {
        expectError([&] { importedScene(addElements); }, ErrorKind::badInput, text);
    };
    refused([](const candela_host& host) { host.add_cage(host.self, nullptr); },
            "test: cage 0: the struct is NULL");
    refused([](const candela_host& host) { host.add_skin(host.self, nullptr); },
            "test: skin 0: the struct is NULL");
    refused([](const candela_host& host) { host.add_cage_instance(host.self, nullptr); },
            "test: add_cage_instance: the struct is NULL");
    const auto shorten = [](auto& source) { source.struct_size = 12; };
    refused([&](const candela_host& host) { add(host, modified(samples::cage(), shorten)); },
            "test: cage 0: struct_size is 12, but version 1.1 has ");
    refused([&](const candela_host& host) { add(host, modified(samples::skin(), shorten)); },
            "test: skin 0: struct_size is 12, but version 1.1 has ");
    refused([&](const candela_host& host) { add(host, modified(samples::cageInstance(), shorten)); },
            "test: add_cage_instance: struct_size is 12, but version 1.1 has ");
}

}  // namespace
}  // namespace candela
