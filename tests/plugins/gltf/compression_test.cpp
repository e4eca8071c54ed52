// Compressed data: what is decoded equals the data that was compressed, and damaged data is named.
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <set>

#include "compressed_files.h"
#include "loading.h"

namespace candela_test {
namespace {

// ---- Meshoptimizer

TEST(Meshopt, attributesAndTrianglesAreExact) {
    for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        const Grid grid = makeGrid(20);
        CompressedFile compressed(extension);
        const int positions = compressed.addView(compressAttributes(grid.positions.data(), 400, 12), 400, 12,
                                                 R"("mode":"ATTRIBUTES")");
        const int indices = compressed.addView(compressTriangles(grid.indices, 400), grid.indices.size(), 4,
                                               R"("mode":"TRIANGLES")");
        compressed.file.addAccessor(positions, "VEC3", 5126, 400);
        const int normals = compressed.addView(compressAttributes(grid.normals.data(), 400, 12), 400, 12,
                                               R"("mode":"ATTRIBUTES")");
        compressed.file.addAccessor(indices, "SCALAR", 5125, grid.indices.size());
        compressed.file.addAccessor(normals, "VEC3", 5126, 400);
        compressed.file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":2},"indices":1)");
        const candela::ImportedScene imported = load(compressed.finish());
        EXPECT_TRUE(imported.report.notes.empty()) << extension;
        const candela::Mesh& mesh = imported.scene.meshes.at(0);
        ASSERT_EQ(mesh.positions.size(), 400u);
        EXPECT_EQ(std::memcmp(mesh.positions.data(), grid.positions.data(), 400 * 12), 0);
        // The codec may turn a triangle, which keeps its orientation.
        const auto turned = [](const std::vector<std::uint32_t>& corners) {
            std::vector<std::array<std::uint32_t, 3>> triangles;
            for (std::size_t i = 0; i < corners.size(); i += 3) {
                std::array<std::uint32_t, 3> t{corners[i], corners[i + 1], corners[i + 2]};
                std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
                triangles.push_back(t);
            }
            return triangles;
        };
        EXPECT_EQ(turned(mesh.indices), turned(grid.indices));
    }
}

TEST(Meshopt, indexSequencesAreExact) {
    const std::vector<std::uint32_t> strip{0, 1, 2, 3, 4, 5};
    const std::vector<float> positions{0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 0, 2, 1, 1, 2, 1};
    CompressedFile compressed;
    const int view =
        compressed.addView(compressAttributes(positions.data(), 6, 12), 6, 12, R"("mode":"ATTRIBUTES")");
    const int indices = compressed.addView(compressIndices(strip, 6), 6, 2, R"("mode":"INDICES")");
    compressed.file.addAccessor(view, "VEC3", 5126, 6);
    compressed.file.addAccessor(indices, "SCALAR", 5123, 6);
    compressed.file.addAccessor(view, "VEC3", 5126, 6);  // Normals of some direction.
    compressed.file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":2},"indices":1,"mode":5)");
    EXPECT_EQ(load(compressed.finish()).scene.meshes.at(0).indices,
              (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4}));
}

/// The vertices of a triangle whose attribute `attribute` is the compressed view.
candela::Mesh triangleWith(const Bytes& compressed, std::size_t stride, const std::string& filter,
                           const std::string& attribute, const std::string& type, int componentType,
                           const std::string& more) {
    const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
    CompressedFile file("KHR_meshopt_compression");
    const int view =
        file.addView(compressAttributes(positions.data(), 3, 12), 3, 12, R"("mode":"ATTRIBUTES")");
    const int data = file.addView(compressed, 3, stride, R"("mode":"ATTRIBUTES","filter":")" + filter + "\"");
    file.file.addAccessor(view, "VEC3", 5126, 3);
    file.file.addAccessor(data, type, componentType, 3, more);
    file.file.addMeshNode(R"("attributes":{"POSITION":0,")" + attribute + R"(":1})");
    return load(file.finish()).scene.meshes.at(0);
}

TEST(Meshopt, theOctahedralFilterGivesUnitVectors) {
    const float normals[] = {0.6f, 0.0f, 0.8f, 0.0f, 0.0f, -0.6f, 0.8f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f};
    std::vector<std::int16_t> encoded(12);
    meshopt_encodeFilterOct(encoded.data(), 3, 8, 16, normals);
    const candela::Mesh mesh = triangleWith(compressAttributes(encoded.data(), 3, 8), 8, "OCTAHEDRAL",
                                            "NORMAL", "VEC3", 5122, R"("normalized":true)");
    for (std::size_t i = 0; i < 3; ++i) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(mesh.normals.at(i)[c], normals[4 * i + std::size_t(c)], 1e-3f);
    }
}

TEST(Meshopt, theExponentialFilterKeepsItsMantissa) {
    const std::vector<float> uvs{0.25f, 3.5f, -7.0f, 1000.0f, 0.5f, 0.0f};
    std::vector<std::uint32_t> encoded(6);
    meshopt_encodeFilterExp(encoded.data(), 3, 8, 15, uvs.data());
    const candela::Mesh mesh = triangleWith(compressAttributes(encoded.data(), 3, 8), 8, "EXPONENTIAL",
                                            "TEXCOORD_0", "VEC2", 5126, "");
    // Components share the exponent of the largest one, and have 15 bits.
    for (std::size_t i = 0; i < 3; ++i) {
        const float largest = std::max(std::abs(uvs[2 * i]), std::abs(uvs[2 * i + 1]));
        for (int c = 0; c < 2; ++c)
            EXPECT_NEAR(mesh.uv0.at(i)[c], uvs[2 * i + std::size_t(c)], largest * 1e-4f);
    }
}

TEST(Meshopt, theColorFilterGivesItsColors) {
    // Luma, orange and green differences and alpha of 8 bits: white, red and half-transparent grey. 7 bits of
    // alpha below a bit that is set.
    const std::vector<std::uint8_t> encoded{255,     0,   0,
                                            255,  // 1, 1, 1, 1
                                            64,      127, static_cast<std::uint8_t>(-64),
                                            255,  // about 1, 0, 0
                                            128,     0,   0,
                                            128 + 64};
    const candela::Mesh mesh = triangleWith(compressAttributes(encoded.data(), 3, 4), 4, "COLOR", "COLOR_0",
                                            "VEC4", 5121, R"("normalized":true)");
    const float expected[3][4] = {{1, 1, 1, 1}, {1, 0, 0, 1}, {0.5f, 0.5f, 0.5f, 0.5f}};
    for (std::size_t i = 0; i < 3; ++i) {
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(mesh.colors.at(i)[c], expected[i][c], 1.0f / 255.0f + 1e-6f);
    }
}

TEST(Meshopt, damagedDataLeavesOutWhatUsesIt) {
    const Grid grid = makeGrid(20);
    Bytes cut = compressAttributes(grid.positions.data(), 400, 12);
    cut.resize(cut.size() / 2);
    CompressedFile compressed;
    compressed.addView(cut, 400, 12, R"("mode":"ATTRIBUTES")");
    compressed.file.addAccessor(0, "VEC3", 5126, 400);
    compressed.file.addMeshNode(R"("attributes":{"POSITION":0})");
    EXPECT_NE(errorOf(compressed.finish())
                  .find("bufferView 0, EXT_meshopt_compression: the compressed data is damaged"),
              std::string::npos);
}

TEST(Meshopt, claimsAreCheckedBeforeMemoryIsAllocated) {
    const Bytes compressed(100, 0xA0);
    CompressedFile file;
    file.addView(compressed, 4000000000u, 256, R"("mode":"ATTRIBUTES")");
    file.file.addAccessor(0, "VEC3", 5126, 3);
    file.file.addMeshNode(R"("attributes":{"POSITION":0})");
    EXPECT_NE(
        errorOf(file.finish()).find("100 compressed bytes cannot hold 4000000000 elements of 256 bytes"),
        std::string::npos);
}

TEST(Meshopt, wrongLayoutsAreNamed) {
    CompressedFile file;
    file.addView(Bytes(100, 0xA0), 30, 6, R"("mode":"ATTRIBUTES")");
    file.file.addAccessor(0, "VEC3", 5123, 30);
    file.file.addMeshNode(R"("attributes":{"POSITION":0})");
    EXPECT_NE(errorOf(file.finish()).find("expected ATTRIBUTES with a byteStride that is a multiple of 4"),
              std::string::npos);
}

// ---- Draco

using Point = std::array<int, 3>;

/// The corners of all triangles, in steps of `step`.
std::multiset<Point> cornersOf(const std::vector<float>& positions, const std::vector<std::uint32_t>& indices,
                               float step) {
    std::multiset<Point> corners;
    for (const std::uint32_t index : indices) {
        Point point;
        for (std::size_t c = 0; c < 3; ++c)
            point[c] = static_cast<int>(std::lround(positions[3 * index + c] / step));
        corners.insert(point);
    }
    return corners;
}

TEST(Draco, sequentialAndEdgebreakerStreamsEqualTheirMesh) {
    const Grid grid = makeGrid(20);
    for (const int speed : {0, 5, 10}) {
        const candela::ImportedScene imported =
            load(dracoFile(compressGrid(grid, speed), 400, grid.indices.size()));
        EXPECT_TRUE(imported.report.notes.empty());
        const candela::Mesh& mesh = imported.scene.meshes.at(0);
        ASSERT_EQ(mesh.positions.size(), 400u);
        ASSERT_EQ(mesh.indices.size(), grid.indices.size());
        std::vector<float> positions(1200);
        std::memcpy(positions.data(), mesh.positions.data(), 4800);
        // 14 bits over a side of 1 m, and vertices at least 0.05 m apart along x and y.
        EXPECT_EQ(cornersOf(positions, mesh.indices, 0.01f), cornersOf(grid.positions, grid.indices, 0.01f));
        for (std::size_t i = 0; i < 400; ++i) {
            const float slope = std::cos(3.0f * positions[3 * i]);
            EXPECT_NEAR(mesh.normals[i].x, -slope / std::hypot(slope, 1.0f), 5e-3f) << "10 bits";
        }
    }
}

TEST(Draco, streamsOfOtherCountsSayHowManyVerticesTheyHave) {
    const Grid grid = makeGrid(20);
    const candela::ImportedScene imported = load(dracoFile(compressGrid(grid, 5), 7, 9));
    EXPECT_EQ(imported.scene.meshes.at(0).positions.size(), 400u);
}

TEST(Draco, damagedStreamsAreNamed) {
    const Grid grid = makeGrid(20);
    const Bytes whole = compressGrid(grid, 5);
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() / 2));
    const std::string error = errorOf(dracoFile(cut, 400, grid.indices.size()));
    EXPECT_NE(error.find("mesh 0, primitive 0, KHR_draco_mesh_compression: the compressed data is damaged"),
              std::string::npos)
        << error;
}

TEST(Draco, uncompressedDataIsReadWhereTheStreamIsDamaged) {
    GltfFile file = triangleFile(
        R"("extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":0}}})");
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(candela::triangleCount(imported.scene), 1u);
    EXPECT_TRUE(hasNote(imported, "the uncompressed data is read"));
}

TEST(Draco, claimsAreCheckedBeforeMemoryIsAllocated) {
    // The header of a sequential stream of version 2.2 that claims 2^32 - 1 faces and vertices.
    Bytes stream{'D', 'R', 'A', 'C', 'O', 2, 2, 1, 0, 0, 0};
    for (int i = 0; i < 2; ++i) stream.insert(stream.end(), {0xFF, 0xFF, 0xFF, 0xFF, 0x0F});
    stream.resize(40);
    EXPECT_NE(errorOf(dracoFile(stream, 3, 3))
                  .find("40 compressed bytes cannot hold 8589934590 vertices and faces"),
              std::string::npos);
}

// ---- WebP

GltfFile webpFile(const Bytes& image) {
    return fileWithImage("data:image/webp;base64," + base64(image), "EXT_texture_webp");
}

TEST(Webp, losslessTexelsAreExact) {
    const std::vector<std::uint8_t> rgba{1, 2, 3, 255, 250, 100, 0, 255, 9, 9, 9, 128, 0, 255, 0, 64};
    const candela::ImportedScene imported = load(webpFile(makeWebp(rgba, 2, 2)));
    EXPECT_TRUE(hasNote(imported, "TEXCOORD_0")) << "the triangle has no coordinates";
    const candela::Image& image = imported.scene.images.at(0);
    EXPECT_EQ(image.width, 2u);
    ASSERT_EQ(image.pixels.size(), rgba.size());
    EXPECT_EQ(std::memcmp(image.pixels.data(), rgba.data(), rgba.size()), 0);
    EXPECT_TRUE(imported.scene.materials.at(0).emissionTexture);
}

TEST(Webp, damagedFilesAreLeftOut) {
    const std::vector<std::uint8_t> rgba(4 * 64 * 64, 77);
    Bytes image = makeWebp(rgba, 64, 64);
    image.resize(image.size() - 10);
    const candela::ImportedScene imported = load(webpFile(image));
    EXPECT_TRUE(hasNote(imported, "image 0 'picture': the WebP file is broken"));
    EXPECT_FALSE(imported.scene.materials.at(0).emissionTexture);
}

// ---- KTX2

#if CANDELA_HAS_KTX2
TEST(Ktx2, bothCodecsAreDecodedToTexels) {
    for (const char* file : {etc1sFile, uastcFile}) {
        const candela::ImportedScene imported =
            load(fileWithImage(std::string("data:image/ktx2;base64,") + file, "KHR_texture_basisu"));
        const candela::Image& image = imported.scene.images.at(0);
        ASSERT_EQ(image.width, 8u);
        ASSERT_EQ(image.height, 4u);
        for (std::size_t i = 0; i < 32; ++i) {
            const int expected[2][4] = {{200, 40, 20, 255}, {20, 60, 220, 128}};
            for (std::size_t c = 0; c < 4; ++c) {
                const int texel = std::to_integer<int>(image.pixels.at(4 * i + c));
                // ETC1S has 5 bits a channel.
                EXPECT_NEAR(texel, expected[i % 8 / 4][c], 5) << file << ", texel " << i << ", channel " << c;
            }
        }
    }
}

TEST(Ktx2, filesThatAreCutOffAreLeftOut) {
    for (const std::string file : {etc1sFile, uastcFile}) {
        const std::string cut = file.substr(0, file.size() / 8 * 4);
        const candela::ImportedScene imported =
            load(fileWithImage("data:image/ktx2;base64," + cut, "KHR_texture_basisu"));
        EXPECT_TRUE(hasNote(imported, "image 0 'picture': the KTX2 file is broken"));
    }
}
#else
TEST(Ktx2, isNamedWhereTheBuildDoesNotReadIt) {
    const candela::ImportedScene imported =
        load(fileWithImage(std::string("data:image/ktx2;base64,") + uastcFile, "KHR_texture_basisu"));
    EXPECT_TRUE(hasNote(imported, "a KTX2 file, which this build does not read"));
}
#endif

}  // namespace
}  // namespace candela_test
