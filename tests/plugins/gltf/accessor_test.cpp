#include <gtest/gtest.h>

#include <numeric>

#include "loading.h"

namespace candela_test {
namespace {

using Vectors2 = std::vector<glm::vec2>;
using Vectors3 = std::vector<glm::vec3>;

candela::Mesh meshOf(const GltfFile& file) {
    return load(file).scene.meshes.at(0);
}

/// Adds a node with a triangle whose TEXCOORD_0 is accessor 2.
void addTexturedNode(GltfFile& file) {
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2})");
}

template <typename T>
Vectors2 texcoords(const std::vector<T>& values, const std::string& more) {
    GltfFile file;
    addTriangle(file);
    file.addData<T>("VEC2", values, more);
    file.set("extensionsUsed", R"(["KHR_mesh_quantization"])");
    addTexturedNode(file);
    return meshOf(file).uv0;
}

constexpr const char* normalized = R"("normalized":true)";

TEST(Accessor, readsFloats) {
    EXPECT_EQ(texcoords<float>({0, 0.25f, -3, 4, 5.5f, 1e-20f}, ""),
              (Vectors2{{0, 0.25f}, {-3, 4}, {5.5f, 1e-20f}}));
}

TEST(Accessor, readsUnsignedBytes) {
    EXPECT_EQ(texcoords<std::uint8_t>({0, 1, 2, 127, 128, 255}, ""),
              (Vectors2{{0, 1}, {2, 127}, {128, 255}}));
    const Vectors2 fractions = texcoords<std::uint8_t>({0, 255, 51, 102, 1, 254}, normalized);
    EXPECT_EQ(fractions[0], glm::vec2(0, 1));
    EXPECT_FLOAT_EQ(fractions[1].x, 0.2f);
    EXPECT_FLOAT_EQ(fractions[2].y, 254.0f / 255.0f);
}

TEST(Accessor, readsSignedBytes) {
    EXPECT_EQ(texcoords<std::int8_t>({0, -1, 2, 127, -127, -128}, ""),
              (Vectors2{{0, -1}, {2, 127}, {-127, -128}}));
    // -128 is clamped: both -127 and -128 are -1.
    EXPECT_EQ(texcoords<std::int8_t>({0, 127, -127, -128, 127, 0}, normalized),
              (Vectors2{{0, 1}, {-1, -1}, {1, 0}}));
}

TEST(Accessor, readsUnsignedShorts) {
    EXPECT_EQ(texcoords<std::uint16_t>({0, 1, 256, 65535, 3, 4}, ""),
              (Vectors2{{0, 1}, {256, 65535}, {3, 4}}));
    const Vectors2 fractions = texcoords<std::uint16_t>({0, 65535, 13107, 0, 1, 0}, normalized);
    EXPECT_EQ(fractions[0], glm::vec2(0, 1));
    EXPECT_FLOAT_EQ(fractions[1].x, 0.2f);
    EXPECT_FLOAT_EQ(fractions[2].x, 1.0f / 65535.0f);
}

TEST(Accessor, readsSignedShorts) {
    EXPECT_EQ(texcoords<std::int16_t>({0, -1, 256, 32767, -32768, 4}, ""),
              (Vectors2{{0, -1}, {256, 32767}, {-32768, 4}}));
    EXPECT_EQ(texcoords<std::int16_t>({0, 32767, -32767, -32768, 32767, 0}, normalized),
              (Vectors2{{0, 1}, {-1, -1}, {1, 0}}));
}

template <typename T>
std::vector<std::uint32_t> indicesAs() {
    GltfFile file;
    addTriangle(file);
    file.addData<T>("SCALAR", {2, 0, 1});
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1},"indices":2)");
    return meshOf(file).indices;
}

TEST(Accessor, readsIndicesOfEveryType) {
    const std::vector<std::uint32_t> expected{2, 0, 1};
    EXPECT_EQ(indicesAs<std::uint8_t>(), expected);
    EXPECT_EQ(indicesAs<std::uint16_t>(), expected);
    EXPECT_EQ(indicesAs<std::uint32_t>(), expected);
}

TEST(Accessor, followsStrideAndOffset) {
    // Position and texture coordinate interleaved: 20 bytes a vertex.
    const std::vector<float> vertices{0, 0, 0, 0.1f, 0.2f, 1, 0, 0, 0.3f, 0.4f, 0, 1, 0, 0.5f, 0.6f};
    GltfFile file;
    const int view = file.addView(bytesOf(vertices), R"("byteStride":20)");
    file.addAccessor(view, "VEC3", 5126, 3);
    const std::vector<float> normals{0, 0, 1, 0, 0, 1, 0, 0, 1};
    file.addData<float>("VEC3", normals);
    file.addAccessor(view, "VEC2", 5126, 3, R"("byteOffset":12)");
    addTexturedNode(file);
    const candela::Mesh mesh = meshOf(file);
    EXPECT_EQ(mesh.positions, (Vectors3{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.uv0, (Vectors2{{0.1f, 0.2f}, {0.3f, 0.4f}, {0.5f, 0.6f}}));
}

TEST(Accessor, readsNumbersThatAreNotAligned) {
    Bytes uvs = bytesOf<float>({0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f}),
          indices = bytesOf<std::uint32_t>({2, 0, 1});
    uvs.insert(uvs.begin(), 1, 99);
    indices.insert(indices.begin(), 2, 99);
    GltfFile file;
    addTriangle(file);
    file.addAccessor(file.addView(uvs), "VEC2", 5126, 3, R"("byteOffset":1)");
    file.addAccessor(file.addView(indices), "SCALAR", 5125, 3, R"("byteOffset":2)");
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"indices":3)");
    const candela::Mesh mesh = meshOf(file);
    EXPECT_EQ(mesh.uv0, (Vectors2{{0.1f, 0.2f}, {0.3f, 0.4f}, {0.5f, 0.6f}}));
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{2, 0, 1}));
}

// What a primitive has in the buffer is changed for it alone.
TEST(Accessor, primitivesShareWhatIsChangedForOne) {
    GltfFile file;
    addTriangle(file);
    const float far = 2e9f;
    const int broken = file.addData<float>("VEC3", {0, 0, 0, far, 0, 0, 0, 1, 0, 1, 1, 0});
    const int normals = file.addData<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int indices = file.addData<std::uint32_t>("SCALAR", {0, 2, 3, 0, 1, 2});
    const auto primitive = [&](int positions) {
        return R"({"attributes":{"POSITION":)" + std::to_string(positions) + R"(,"NORMAL":)" +
               std::to_string(normals) + R"(},"indices":)" + std::to_string(indices) + "}";
    };
    const int whole = file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    file.add("meshes", R"({"primitives":[)" + primitive(broken) + "," + primitive(whole) + "]}");
    file.add("nodes", R"({"mesh":0})");
    const candela::Mesh mesh = meshOf(file);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 2, 3, 4, 6, 7, 4, 5, 6}));
    EXPECT_EQ(mesh.positions[1], glm::vec3(0.0f)) << "what is broken is left out";
    EXPECT_EQ(mesh.positions[5], glm::vec3(1, 0, 0));
}

TEST(Accessor, theLastElementOfAStrideNeedsNoPadding) {
    // 3 elements of 2 bytes at a stride of 4: the view ends with the last element, at byte 10.
    GltfFile file;
    addTriangle(file);
    const int view = file.addView({1, 2, 0, 0, 3, 4, 0, 0, 5, 6}, R"("byteStride":4)");
    file.addAccessor(view, "VEC2", 5121, 3);
    file.set("extensionsUsed", R"(["KHR_mesh_quantization"])");
    addTexturedNode(file);
    EXPECT_EQ(meshOf(file).uv0, (Vectors2{{1, 2}, {3, 4}, {5, 6}}));
}

template <typename Index>
Vectors2 sparseTexcoords(bool withBase) {
    GltfFile file;
    addTriangle(file);
    const int base = withBase ? file.addView(bytesOf<float>({1, 1, 2, 2, 3, 3})) : -1;
    // 4 other bytes precede each array, so that the byteOffsets matter.
    Bytes indexBytes(4, 0xEE), valueBytes(4, 0xEE);
    for (const std::uint8_t byte : bytesOf<Index>({0, 2})) indexBytes.push_back(byte);
    for (const std::uint8_t byte : bytesOf<float>({7, 8, 9, 10})) valueBytes.push_back(byte);
    const std::string indices = std::to_string(file.addView(indexBytes));
    const std::string values = std::to_string(file.addView(valueBytes));
    file.addAccessor(base, "VEC2", 5126, 3,
                     R"("sparse":{"count":2,"indices":{"bufferView":)" + indices +
                         R"(,"byteOffset":4,"componentType":)" + std::to_string(componentTypeOf<Index>()) +
                         R"(},"values":{"bufferView":)" + values + R"(,"byteOffset":4}})");
    addTexturedNode(file);
    return meshOf(file).uv0;
}

TEST(Accessor, appliesSparseValues) {
    const Vectors2 expected{{7, 8}, {2, 2}, {9, 10}};
    EXPECT_EQ(sparseTexcoords<std::uint8_t>(true), expected);
    EXPECT_EQ(sparseTexcoords<std::uint16_t>(true), expected);
    EXPECT_EQ(sparseTexcoords<std::uint32_t>(true), expected);
}

TEST(Accessor, appliesSparseValuesToZeros) {
    EXPECT_EQ(sparseTexcoords<std::uint16_t>(false), (Vectors2{{7, 8}, {0, 0}, {9, 10}}));
}

TEST(Accessor, withoutABufferViewIsZero) {
    GltfFile file;
    addTriangle(file);
    file.addAccessor(-1, "VEC2", 5126, 3);
    addTexturedNode(file);
    EXPECT_EQ(meshOf(file).uv0, Vectors2(3, glm::vec2(0)));
}

TEST(Accessor, indicesWithoutABufferViewAreZero) {
    GltfFile file;
    addTriangle(file);
    file.addAccessor(-1, "SCALAR", 5123, 3);
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1},"indices":2)");
    EXPECT_EQ(meshOf(file).indices, std::vector<std::uint32_t>(3, 0));
}

TEST(Accessor, quantizedPositionsNormalsAndTangents) {
    GltfFile file;
    file.set("extensionsRequired", R"(["KHR_mesh_quantization"])");
    const int positions =
        file.addView(bytesOf<std::int16_t>({0, 0, -5, 0, 10, 0, 0, 0, 0, 20, 300, 0}), R"("byteStride":8)");
    file.addAccessor(positions, "VEC3", 5122, 3);
    const int normals =
        file.addView(bytesOf<std::int8_t>({0, 0, 127, 0, 0, 0, 127, 0, 0, 127, 0, 0}), R"("byteStride":4)");
    file.addAccessor(normals, "VEC3", 5120, 3, normalized);
    file.addData<std::int8_t>("VEC4", {127, 0, 0, 127, 127, 0, 0, -127, 127, 0, 0, -128}, normalized);
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1,"TANGENT":2})");
    const candela::Mesh mesh = meshOf(file);
    EXPECT_EQ(mesh.positions, (Vectors3{{0, 0, -5}, {10, 0, 0}, {0, 20, 300}}));
    EXPECT_EQ(mesh.normals, (Vectors3{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}));
    EXPECT_EQ(mesh.tangents, (std::vector<glm::vec4>{{1, 0, 0, 1}, {1, 0, 0, -1}, {1, 0, 0, -1}}));
}

}  // namespace
}  // namespace candela_test
