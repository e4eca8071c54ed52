#include <gtest/gtest.h>

#include <cmath>

#include "cage_file.h"

namespace candela_test {
namespace {

using Indices = std::vector<std::uint32_t>;

/// A cage of ten distinct vertices on a circle with these triangles.
GltfFile circleFile(const std::vector<std::uint8_t>& triangles, Faces faces, const std::string& more = "") {
    GltfFile file;
    std::vector<float> positions;
    for (int i = 0; i < 10; ++i) {
        const float angle = static_cast<float>(i) * 0.6f;
        positions.insert(positions.end(), {std::cos(angle), std::sin(angle), 0.0f});
    }
    file.addData<float>("VEC3", positions);
    file.addData<std::uint8_t>("SCALAR", triangles);
    addCageMesh(file, R"({"attributes":{"POSITION":0},"indices":1)" + facesMember(faces) + more + "}", "{}");
    return file;
}

TEST(Ngon, withoutTheExtensionFacesAreTriangles) {
    const candela::Cage cage = cageOf(circleFile({0, 1, 2, 0, 2, 3}, Faces::triangles));
    EXPECT_EQ(cage.faceSizes, (Indices{3, 3}));
    EXPECT_EQ(cage.faceVertices, (Indices{0, 1, 2, 0, 2, 3}));
}

TEST(Ngon, eachFanIsOnePolygon) {
    // A pentagon about 0, a triangle about 4, a quad about 6, and a triangle about 0 again.
    const candela::Cage cage = cageOf(
        circleFile({0, 1, 2, 0, 2, 3, 0, 3, 4, 4, 5, 6, 6, 7, 8, 6, 8, 9, 0, 4, 9}, Faces::ngonEncoding));
    EXPECT_EQ(cage.faceSizes, (Indices{5, 3, 4, 3}));
    EXPECT_EQ(cage.faceVertices, (Indices{0, 1, 2, 3, 4, 4, 5, 6, 6, 7, 8, 9, 0, 4, 9}));
}

TEST(Ngon, aPolygonMayStartAtAnyOfItsVertices) {
    // Both quads have vertex 0. The second one has to start at another vertex, since the first starts there.
    const candela::Cage cage = cageOf(circleFile({0, 1, 2, 0, 2, 3, 3, 4, 5, 3, 5, 0}, Faces::ngonEncoding));
    EXPECT_EQ(cage.faceVertices, (Indices{0, 1, 2, 3, 3, 4, 5, 0}));
}

TEST(Ngon, aDiscontinuousFanIsAnError) {
    const std::string error = errorOf(circleFile({0, 1, 2, 0, 2, 3, 0, 4, 5}, Faces::ngonEncoding));
    EXPECT_NE(error.find("mesh 0 'cage', primitive 0, FB_ngon_encoding: triangle 2"), std::string::npos)
        << error;
    EXPECT_NE(error.find("vertex 4, expected 3"), std::string::npos) << error;
}

TEST(Ngon, otherModesAreAnError) {
    const std::string error = errorOf(circleFile({0, 1, 2, 3}, Faces::ngonEncoding, R"(,"mode":5)"));
    EXPECT_NE(error.find("FB_ngon_encoding and mode 5"), std::string::npos) << error;
}

TEST(Ngon, theExtensionIsSupported) {
    GltfFile file = circleFile({0, 1, 2, 0, 2, 3}, Faces::ngonEncoding);
    file.set("extensionsUsed", R"(["FB_ngon_encoding"])");
    file.set("extensionsRequired", R"(["FB_ngon_encoding"])");
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(imported.scene.cages.at(0).faceSizes, Indices{4});
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(Ngon, meshesThatAreNotCagesKeepTheirTriangles) {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    file.addData<std::uint8_t>("SCALAR", {0, 1, 2, 0, 3, 1});
    file.addMeshNode(R"("attributes":{"POSITION":0},"indices":1)" + facesMember(Faces::ngonEncoding));
    const candela::Scene scene = load(file).scene;
    EXPECT_EQ(candela::triangleCount(scene), 2u);
}

}  // namespace
}  // namespace candela_test
