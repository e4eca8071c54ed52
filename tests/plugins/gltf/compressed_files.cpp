#include "compressed_files.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <webp/encode.h>

#include <cmath>
#include <iterator>
#include <memory>

namespace candela_test {

Grid makeGrid(std::uint32_t side) {
    Grid grid;
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(side - 1);
            const float v = static_cast<float>(y) / static_cast<float>(side - 1);
            const float slope = std::cos(3.0f * u);
            const float length = std::hypot(slope, 1.0f);
            grid.positions.insert(grid.positions.end(), {u, v, std::sin(3.0f * u) / 3.0f});
            grid.normals.insert(grid.normals.end(), {-slope / length, 0.0f, 1.0f / length});
        }
    }
    for (std::uint32_t y = 0; y + 1 < side; ++y) {
        for (std::uint32_t x = 0; x + 1 < side; ++x) {
            const std::uint32_t at = y * side + x;
            const std::uint32_t corners[] = {at, at + 1, at + side, at + 1, at + side + 1, at + side};
            grid.indices.insert(grid.indices.end(), std::begin(corners), std::end(corners));
        }
    }
    return grid;
}

Bytes compressAttributes(const void* elements, std::size_t count, std::size_t stride) {
    Bytes bytes(meshopt_encodeVertexBufferBound(count, stride));
    bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), elements, count, stride));
    return bytes;
}

Bytes compressTriangles(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
    Bytes bytes(meshopt_encodeIndexBufferBound(indices.size(), vertices));
    bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), indices.data(), indices.size()));
    return bytes;
}

Bytes compressIndices(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
    Bytes bytes(meshopt_encodeIndexSequenceBound(indices.size(), vertices));
    bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), indices.data(), indices.size()));
    return bytes;
}

int CompressedFile::addView(const Bytes& compressed, std::size_t count, std::size_t stride,
                            const std::string& more) {
    binary_.resize((binary_.size() + 3) / 4 * 4);
    const std::string offset = std::to_string(binary_.size());
    binary_.insert(binary_.end(), compressed.begin(), compressed.end());
    const bool isAttribute = more.find("ATTRIBUTES") != std::string::npos;
    const std::string strideMember = isAttribute ? R"(,"byteStride":)" + std::to_string(stride) : "";
    return file.add("bufferViews",
                    R"({"buffer":1,"byteLength":)" + std::to_string(count * stride) + strideMember +
                        R"(,"extensions":{")" + extension_ + R"(":{"buffer":0,"byteOffset":)" + offset +
                        R"(,"byteLength":)" + std::to_string(compressed.size()) + R"(,"byteStride":)" +
                        std::to_string(stride) + R"(,"count":)" + std::to_string(count) + "," + more + "}}}");
}

GltfFile CompressedFile::finish() {
    file.set("extensionsRequired", "[\"" + extension_ + "\",\"KHR_mesh_quantization\"]");
    file.add("buffers", R"({"byteLength":)" + std::to_string(binary_.size()) +
                            R"(,"uri":"data:application/octet-stream;base64,)" + base64(binary_) + "\"}");
    file.add("buffers", R"({"byteLength":1000000})");
    return file;
}

Bytes compressGrid(const Grid& grid, int speed) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(static_cast<int>(grid.indices.size() / 3));
    const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int normal = builder.AddAttribute(draco::GeometryAttribute::NORMAL, 3, draco::DT_FLOAT32);
    for (std::uint32_t face = 0; face < grid.indices.size() / 3; ++face) {
        const std::uint32_t* c = &grid.indices[face * 3];
        builder.SetAttributeValuesForFace(position, draco::FaceIndex(face), &grid.positions[c[0] * 3],
                                          &grid.positions[c[1] * 3], &grid.positions[c[2] * 3]);
        builder.SetAttributeValuesForFace(normal, draco::FaceIndex(face), &grid.normals[c[0] * 3],
                                          &grid.normals[c[1] * 3], &grid.normals[c[2] * 3]);
    }
    const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetSpeedOptions(speed, speed);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::NORMAL, 10);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    return Bytes(buffer.data(), buffer.data() + buffer.size());
}

GltfFile dracoFile(const Bytes& stream, std::size_t vertices, std::size_t indices) {
    GltfFile file;
    file.set("extensionsRequired", R"(["KHR_draco_mesh_compression"])");
    file.addView(stream);
    file.addAccessor(-1, "VEC3", 5126, vertices);
    file.addAccessor(-1, "VEC3", 5126, vertices);
    file.addAccessor(-1, "SCALAR", 5123, indices);
    file.addMeshNode(
        R"("attributes":{"POSITION":0,"NORMAL":1},"indices":2,"extensions":{)"
        R"("KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":0,"NORMAL":1}}})");
    return file;
}

Bytes makeWebp(const std::vector<std::uint8_t>& rgba, int width, int height) {
    std::uint8_t* output = nullptr;
    const std::size_t size = WebPEncodeLosslessRGBA(rgba.data(), width, height, 4 * width, &output);
    const Bytes bytes(output, output + size);
    WebPFree(output);
    return bytes;
}

const char* const etc1sFile =
    "q0tUWCAyMLsNChoKAAAAAAEAAAAIAAAABAAAAAAAAAAAAAAAAQAAAAEAAAABAAAAaAAAADwAAACkAAAAJAAAAMgAAA"
    "AAAAAAjQAAAAAAAABVAQAAAAAAAAIAAAAAAAAAAAAAAAAAAAA8AAAAAAAAAAIAOACjAQIAAwMAAAAAAAAAAAAAAAA/"
    "AAAAAAAAAAAA/////0AAPw8AAAAAAAAAAP////8fAAAAS1RYd3JpdGVyAEJhc2lzIFVuaXZlcnNhbCAxLjE2AAAEAA"
    "IAMQAAAAkAAAArAAAAAAAAAAAAAAAAAAAAAQAAAAEAAAABAAAAHsCUAAAAAAAAskIEAkwEAAAAAAAgCw50AHEDBAAA"
    "ACCDkiMgAFMAAAAAACBQFn2gKVRVVVX9////BwDBRAAAAAAAAPJfjQCYABAAAAAAQHQAmAAQAAAAAEAcAEwAAAAAAA"
    "AggAAaHA==";

const char* const uastcFile =
    "q0tUWCAyMLsNChoKAAAAAAEAAAAIAAAABAAAAAAAAAAAAAAAAQAAAAEAAAACAAAAaAAAACwAAACUAAAAJAAAAAAAAA"
    "AAAAAAAAAAAAAAAAC4AAAAAAAAACAAAAAAAAAAIAAAAAAAAAAsAAAAAAAAAAIAKACmAQIAAwMAAAAAAAAAAAAAAAB/"
    "AwAAAAAAAAAA/////x8AAABLVFh3cml0ZXIAQmFzaXMgVW5pdmVyc2FsIDEuMTYAACi1L/0gIL0AAHgXGYXiP7UDAJ"
    "eChxuwMMsCADSLIQAX";

GltfFile fileWithImage(const std::string& uri, const std::string& extension) {
    GltfFile file = triangleFile(R"("material":0)");
    file.set("extensionsRequired", "[\"" + extension + "\"]");
    file.add("images", R"({"name":"picture","uri":")" + uri + "\"}");
    file.add("textures", R"({"extensions":{")" + extension + R"(":{"source":0}}})");
    file.add("materials", R"({"emissiveTexture":{"index":0}})");
    return file;
}

}  // namespace candela_test
