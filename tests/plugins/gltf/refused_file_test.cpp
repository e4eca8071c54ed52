// What is no glTF 2.0, or has nothing left that can be drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "broken_files.h"

namespace candela_test {
namespace {

/// A document whose only mesh reads a buffer with these members.
std::string withBuffer(const std::string& buffer) {
    return document(R"("buffers":[{)" + buffer +
                    R"(}],"bufferViews":[{"buffer":0,"byteOffset":4,"byteLength":36}],"accessors":
        [{"bufferView":0,"type":"VEC3","componentType":5126,"count":3}],"meshes":[{"primitives":
        [{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}])");
}

/// What is no glTF 2.0, or has nothing that can be drawn for what is broken in it.
std::vector<Case> refusedDocuments() {
    return {
        {"empty", "", {"JSON"}},
        {"notJson", "{\"asset\":", {"JSON", "line 1"}},
        {"array", "[]", {"JSON", "not an object"}},
        {"utf16", std::string("\xFF\xFE{\0", 4), {"JSON", "UTF-16"}},
        {"hugeNumber", document(R"("nodes":[{"translation":[1e999,0,0]}])"), {"JSON"}},
        {"noAsset", "{}", {"asset", "missing"}},
        {"noVersion", R"({"asset":{}})", {"asset", "version"}},
        {"oldVersion", R"({"asset":{"version":"1.0"}})", {"asset", "glTF 1.0", "expected glTF 2.0"}},
        {"oldForm", R"({"nodes":{"a":{}},"meshes":{}})", {"asset", "glTF 1.0"}},
        {"oddVersion", R"({"asset":{"version":"two"}})", {"asset", "'two'"}},
        {"laterMinimum", R"({"asset":{"version":"2.1","minVersion":"2.1"}})", {"asset", "minVersion 2.1"}},
        {"requiredExtension",
         document(R"("extensionsRequired":["VENDOR_shape"])"),
         {"extensionsRequired", "'VENDOR_shape' is not supported"}},
        {"nodesNotAnArray", document(R"("nodes":{"a":1})"), {"nodes", "expected an array"}},
        {"nodeNotAnObject", document(R"("nodes":[1])"), {"node 0", "not an object"}},
        {"meshIndex", document(R"("nodes":[{"mesh":-1}])"), {"node 0, mesh", "mesh -1 does not exist"}},
        {"noPrimitives",
         document(R"("nodes":[{"mesh":0}],"meshes":[{"name":"wheel"}])"),
         {"mesh 0 'wheel'", "primitives"}},
        {"noAttributes", withPrimitives("{}"), {"mesh 0 'wheel', primitive 0", "attributes"}},
        {"positionIndex",
         withPrimitives(R"({"attributes":{"POSITION":1}})"),
         {"primitive 0, attribute POSITION", "accessor 1 does not exist: the file has 1"}},
        {"mode",
         wheel(onlyTriangle + R"(,"mode":7)").text(),
         {"mesh 0 'wheel', primitive 0, mode", "0 to 6"}},
        {"draco",
         document(R"("extensionsRequired":["KHR_draco_mesh_compression"],"nodes":[{"mesh":0}],
             "accessors":[{"type":"VEC3","componentType":5126,"count":3}],"bufferViews":[],
             "meshes":[{"primitives":[{"attributes":{"POSITION":0},"extensions":{"KHR_draco_mesh_compression":
             {"bufferView":0,"attributes":{"POSITION":0}}}}]}])"),
         {"mesh 0, primitive 0, KHR_draco_mesh_compression", "bufferView 0 does not exist"}},
        {"meshopt",
         document(R"("buffers":[{"byteLength":1,"uri":"data:,A"},{"byteLength":36}],"nodes":[{"mesh":0}],
             "bufferViews":[{"buffer":1,"byteLength":36,"extensions":{"EXT_meshopt_compression":{"buffer":0}}}],
             "accessors":[{"bufferView":0,"type":"VEC3","componentType":5126,"count":3}],
             "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])"),
         {"mesh 0, primitive 0, attribute POSITION", "bufferView 0", "\"byteLength\" is missing"}},
        {"hugeZeros",
         [] {
             GltfFile file;
             file.addAccessor(-1, "VEC3", 5126, 4000000000u);
             file.addMeshNode(R"("attributes":{"POSITION":0})");
             return file.text();
         }(),
         {"mesh 0, primitive 0, attribute POSITION", "accessor 0 has no bufferView and 4000000000 elements"}},
        // 16 targets of 2^24 offsets are as much as a file may leave out; the positions are more.
        {"hugeTargets",
         [] {
             GltfFile file;
             file.addAccessor(-1, "VEC3", 5126, 1u << 24);
             std::string targets = R"({"POSITION":0})";
             for (int i = 1; i < 16; ++i) targets += R"(,{"POSITION":0})";
             file.addMeshNode(R"("attributes":{"POSITION":0},"targets":[)" + targets + "]", "wheel");
             return file.text();
         }(),
         {"mesh 0 'wheel', primitive 0",
          "reads 285212672 elements that the file does not hold, expected at most 268435456"}},
        {"hugeAbsentTargets",
         [] {
             GltfFile file;
             file.addAccessor(-1, "VEC3", 5126, 1u << 24);
             file.addData<float>("VEC3", {0, 0, 1});
             std::string targets = R"({"POSITION":1})";
             for (int i = 1; i < 16; ++i) targets += R"(,{"POSITION":1})";
             file.addMeshNode(R"("attributes":{"POSITION":0},"targets":[)" + targets + "]", "wheel");
             return file.text();
         }(),
         {"mesh 0 'wheel', primitive 0", "reads 285212672 elements that the file does not hold"}},
        // Joints are not allocated for vertices that the file does not hold.
        {"hugeSkinnedPosition",
         [] {
             GltfFile file;
             file.addAccessor(file.addView(Bytes(36)), "VEC3", 5126, 4294967294u);
             file.addData<std::uint8_t>("VEC4", Bytes(12));
             file.addData<float>("VEC4", std::vector<float>(12, 1.0f));
             file.addMeshNode(R"("attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2})", "wheel");
             file.add("nodes", R"({"mesh":0,"skin":0})");
             file.add("skins", R"({"joints":[0]})");
             return file.text();
         }(),
         {"mesh 0 'wheel', primitive 0, attribute POSITION",
          "accessor 0 has elements that end at byte 51539607528 of a bufferView of 36"}},
        // 4096 strides are 2^64 bytes, which is 0 in 64 bits.
        {"hugeStride",
         [] {
             GltfFile file;
             file.addAccessor(file.addView(Bytes(36), R"("byteStride":4503599627370496)"), "VEC3", 5126,
                              4097);
             file.addMeshNode(R"("attributes":{"POSITION":0})");
             return file.text();
         }(),
         {"mesh 0, primitive 0, attribute POSITION", "bufferView 0, byteStride",
          "is 4.50359963e+15, expected 0 to 2147483647"}},
        {"noElements",
         [] {
             GltfFile file;
             file.addAccessor(-1, "VEC3", 5126, 0);
             file.addMeshNode(R"("attributes":{"POSITION":0})");
             return file.text();
         }(),
         {"mesh 0, primitive 0, attribute POSITION", "accessor 0 has no elements"}},
        {"indexRange",
         wheelWithIndices({0, 1, 3}),
         {"mesh 0 'wheel', primitive 0, indices", "index 3 at position 2", "3 vertices"}},
        {"indexCount",
         wheelWithIndices({0, 1}),
         {"mesh 0 'wheel', primitive 0", "has 2 corners, expected a multiple of 3"}},
        {"shortStrip", wheelWithIndices({0, 1}, R"(,"mode":5)"), {"primitive 0", "expected 3 or more"}},
        {"indexType",
         [] {
             GltfFile file = wheel(onlyTriangle + R"(,"indices":2)");
             file.addData<float>("SCALAR", {0, 1, 2});
             return file.text();
         }(),
         {"primitive 0, indices", "accessor 2 is SCALAR of FLOAT"}},
        {"notFinite",
         [] {
             GltfFile file;
             file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, std::nanf(""), 0});
             file.addMeshNode(R"("attributes":{"POSITION":0})");
             return file.text();
         }(),
         {"mesh 0, primitive 0, attribute POSITION", "no triangle has vertices that are finite"}},
        {"noBuffers",
         document(R"("bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"type":"VEC3",
             "componentType":5126,"count":3}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
             "nodes":[{"mesh":0}])"),
         {"mesh 0, primitive 0, attribute POSITION", "bufferView 0, buffer", "buffer 0 does not exist"}},
        {"noUri", withBuffer(R"("byteLength":40)"), {"buffer 0", "has no URI"}},
        {"badBase64",
         withBuffer(R"("byteLength":40,"uri":"data:;base64,A*AA")"),
         {"buffer 0", "character 1"}},
        {"cutBase64", withBuffer(R"("byteLength":40,"uri":"data:;base64,AAAAA")"), {"buffer 0", "cut off"}},
        {"badPercent", withBuffer(R"("byteLength":40,"uri":"a%2")"), {"buffer 0", "hexadecimal"}},
        {"zeroInUri", withBuffer(R"("byteLength":40,"uri":"a%00b")"), {"buffer 0", "zero"}},
        {"emptyUri", withBuffer(R"("byteLength":40,"uri":"")"), {"buffer 0", "empty"}},
        {"viewBeyondBuffer",
         withBuffer(R"("byteLength":9,"uri":"data:;base64,AAAAAAAAAAAA")"),
         {"mesh 0, primitive 0, attribute POSITION", "bufferView 0 ends at byte 40, but buffer 0 has 9"}},
    };
}

TEST(RefusedFile, namesWhatIsAtFault) {
    expectErrors(refusedDocuments());
}
/// A .glb of the triangle with one 32-bit number overwritten.
Bytes glbWith(std::size_t offset, std::uint32_t value) {
    Bytes glb = triangleFile().glb();
    std::memcpy(&glb[offset], &value, sizeof value);
    return glb;
}

TEST(RefusedFile, glb) {
    const auto size = static_cast<std::uint32_t>(triangleFile().glb().size());
    std::uint32_t jsonSize = 0;
    const Bytes whole = triangleFile().glb();
    std::memcpy(&jsonSize, &whole[12], sizeof jsonSize);
    const std::pair<Bytes, const char*> refused[] = {
        {glbWith(4, 1), "glTF 1.0 (container version 1)"},
        {glbWith(4, 3), "container version 3, expected 2"},
        {glbWith(12, 0xFFFFFFFC), "chunk 0 has a length of 4294967292 bytes"},
        {glbWith(16, 0), "chunk 0 is not of type JSON"},
        {glbWith(24 + jsonSize, 0), "buffer 0: has no URI, and the file has no BIN chunk"},
        {Bytes(whole.begin(), whole.begin() + 8), "cut off within its header"},
    };
    for (const auto& [glb, part] : refused) {
        const std::string error = errorOfGlb(glb);
        EXPECT_NE(error.find(part), std::string::npos) << "'" << part << "' is not in: " << error;
    }
    const std::pair<Bytes, const char*> noted[] = {
        {glbWith(8, size + 1), "the header says"},
        {glbWith(8, 4), "the header says 4 bytes"},
        // Eight bytes too many: as many as the header of the chunk has.
        {glbWith(20 + jsonSize, size - 20 - jsonSize), "chunk 1 has a length of"},
    };
    for (const auto& [glb, part] : noted) {
        const candela::ImportedScene imported = loadGlb(glb);
        EXPECT_EQ(imported.scene.meshes.size(), 1u);
        EXPECT_TRUE(hasNote(imported, part)) << part;
    }
}

// The limit is that of all primitives, and what the file holds is drawn.
TEST(RefusedFile, elementsThatTheFileDoesNotHoldAreLimited) {
    GltfFile file = triangleFile();
    const std::string most = std::to_string(file.addAccessor(-1, "VEC2", 5126, 1u << 24));
    const std::string more = std::to_string(file.addAccessor(-1, "VEC3", 5126, 3));
    std::string targets = R"({"POSITION":)" + most + "}";
    for (int i = 1; i < 15; ++i) targets += R"(,{"POSITION":)" + most + "}";
    // Counts as 2^28 elements, and is left out for its VEC2 before any is read.
    file.addMeshNode(R"("attributes":{"POSITION":)" + most + R"(},"targets":[)" + targets + "]", "most");
    file.addMeshNode(R"("attributes":{"POSITION":)" + more + "}", "more");
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(imported.scene.meshes.size(), 1u);
    EXPECT_EQ(imported.report.notes.size(), 2u);
    EXPECT_TRUE(hasNote(imported, "mesh 1 'most', primitive 0, attribute POSITION"));
    EXPECT_TRUE(
        hasNote(imported, "mesh 2 'more', primitive 0: reads 3 elements that the file does not hold"));
}

TEST(RefusedFile, deepNestingDoesNotCrash) {
    const std::string deep(200000, '[');
    EXPECT_NE(errorOfText(R"({"asset":{"version":"2.0"},"extras":)" + deep), "");
    const std::string closed = deep + std::string(deep.size(), ']');
    EXPECT_EQ(errorOfText(R"({"asset":{"version":"2.0"},"extras":)" + closed + "}"), "");
    EXPECT_NE(errorOfText(R"({"asset":{"version":"2.0"},"nodes":)" + closed + "}"), "");
}

}  // namespace
}  // namespace candela_test
