#include "plugin_call.h"

#include <candela/error.h>
#include <candela/plugin_registry.h>

#include "generated_cages.h"
#include "plugin_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace candela {
namespace {

void expectRejection(const candela_cage& cage, const std::string& element, const std::string& reason,
                     std::uint32_t level = 2) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const CallResult result = callPlugin(cage, level);
    EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(result.status, CANDELA_FAILED);
    EXPECT_EQ(result.failures, 1);
    EXPECT_FALSE(result.hasResult);
    EXPECT_EQ(result.element, element);
    EXPECT_NE(result.reason.find(reason), std::string::npos) << result.reason;
}

TEST(Rejection, validCagesAreAccepted) {
    CageArrays arrays;
    for (std::uint32_t level = 1; level <= 8; ++level) {
        const CallResult result = callPlugin(arrays.cage, level);
        EXPECT_EQ(result.status, CANDELA_OK) << result.element << ": " << result.reason;
        EXPECT_TRUE(result.hasResult);
    }
}

TEST(Rejection, ofLevels) {
    CageArrays arrays;
    expectRejection(arrays.cage, "level 0", "1 to 8", 0);
    expectRejection(arrays.cage, "level 9", "1 to 8", 9);
}

/// Changes a valid cage and expects its rejection.
template <typename Change>
void expectRejectionAfter(Change change, const std::string& element, const std::string& reason) {
    CageArrays arrays;
    change(arrays);
    expectRejection(arrays.cage, element, reason);
}

TEST(Rejection, ofFaces) {
    expectRejectionAfter([](CageArrays& arrays) { arrays.faceVertices[6] = 6; }, "face 1", "vertex 6");
    expectRejectionAfter([](CageArrays& arrays) { arrays.faceVertices[6] = 1; }, "face 1", "vertex 1 twice");
    expectRejectionAfter([](CageArrays& arrays) { arrays.faceSizes[0] = 2; }, "face 0", "less than 3");
    expectRejectionAfter([](CageArrays& arrays) { arrays.faceUvs[3] = 4; }, "face 0", "texture coordinate 4");
    expectRejectionAfter([](CageArrays& arrays) { arrays.cage.scheme = CANDELA_SCHEME_LOOP; }, "face 0",
                         "only triangles");
    expectRejectionAfter([](CageArrays& arrays) { arrays.cage.face_count = 0; }, "", "no faces");
    const auto addHole = [](CageArrays& arrays) {
        arrays.holes[0] = 2;
        arrays.cage.holes = arrays.holes;
        arrays.cage.hole_count = 1;
    };
    expectRejectionAfter(addHole, "face 2", "only 2 faces");
}

TEST(Rejection, ofSharpness) {
    expectRejectionAfter([](CageArrays& arrays) { arrays.creaseEdges[3] = 4; }, "edge 0-4",
                         "no face has such an edge");
    expectRejectionAfter([](CageArrays& arrays) { arrays.creaseEdges[3] = 6; }, "edge 0-6",
                         "only 6 vertices");
    expectRejectionAfter([](CageArrays& arrays) { arrays.cornerVertices[0] = 7; }, "vertex 7",
                         "only 6 vertices");
    for (const float sharpness :
         {-0.5f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        expectRejectionAfter([&](CageArrays& arrays) { arrays.creaseSharpness[1] = sharpness; }, "edge 0-3",
                             "0 or more");
        expectRejectionAfter([&](CageArrays& arrays) { arrays.cornerSharpness[0] = sharpness; }, "vertex 5",
                             "0 or more");
    }
}

TEST(Rejection, ofMissingArraysAndUnknownRules) {
    expectRejectionAfter([](CageArrays& arrays) { arrays.cage.positions = nullptr; }, "",
                         "positions are missing");
    expectRejectionAfter([](CageArrays& arrays) { arrays.cage.face_vertices = nullptr; }, "",
                         "corners are missing");
    expectRejectionAfter([](CageArrays& arrays) { arrays.cage.crease_sharpness = nullptr; }, "",
                         "crease sharpnesses are missing");
    expectRejectionAfter([](CageArrays& arrays) { arrays.cage.face_count = 0xFFFFFFFFu; }, "",
                         "too many faces");
    const auto setScheme = [](CageArrays& arrays) {
        const int unknown = 3;
        std::memcpy(&arrays.cage.scheme, &unknown, sizeof(unknown));
    };
    expectRejectionAfter(setScheme, "", "its scheme is 3");
}

/// A fan of triangles around vertex 0.
Cage fan(std::uint32_t triangles) {
    std::vector<glm::vec3> points(triangles + 2, glm::vec3(0.0f));
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i < triangles; ++i) faces.push_back({0, i + 1, i + 2});
    return makeCage("fan", points, faces);
}

void expectError(const Cage& cage, std::uint32_t level, const std::string& text) {
    try {
        refineWithPlugin(cage, level);
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
}

TEST(Rejection, ofValencesAndFaceSizesBeyondTheLimits) {
    expectError(fan(65536), 1, "vertex 0");
    Cage polygon = makeCage("polygon", std::vector<glm::vec3>(65536), {{}});
    polygon.faceSizes = {65536};
    for (std::uint32_t i = 0; i < 65536; ++i) polygon.faceVertices.push_back(i);
    expectError(polygon, 1, "face 0");
}

// Each of 12,000 faces has some 800 points at level 5, and depends on 12,000 vertices.
TEST(Rejection, ofTablesThatAreTooLarge) {
    expectError(fan(12000), 5, "level 5");
}

TEST(Plugin, isFoundAsASubdivider) {
    const PluginRegistry registry({CANDELA_TEST_PLUGINS});
    const auto found = registry.reports();
    ASSERT_TRUE(std::any_of(found.begin(), found.end(), [](const PluginReport& report) {
        return report.name == "opensubdiv" && report.subdivides && report.state == PluginState::loaded;
    }));
}

}  // namespace
}  // namespace candela
