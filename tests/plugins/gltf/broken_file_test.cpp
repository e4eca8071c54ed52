#include <gtest/gtest.h>

#include <cmath>

#include "image_files.h"
#include "loading.h"

namespace candela_test {
namespace {

/// A file and what its error message must contain: the element and the reason.
struct Case {
    const char* name;
    std::string text;
    std::vector<std::string> parts;
};

std::string document(const std::string& members) {
    return R"({"asset":{"version":"2.0"},)" + members + "}";
}

/// A node with a mesh 'wheel' whose primitive has these members; accessors 0 and 1 are its positions and
/// normals.
GltfFile wheel(const std::string& primitive) {
    GltfFile file;
    addTriangle(file);
    file.addMeshNode(primitive, "wheel");
    return file;
}

const std::string onlyTriangle = R"("attributes":{"POSITION":0,"NORMAL":1})";

std::string wheelWithIndices(const std::vector<std::uint16_t>& indices, const std::string& more = "") {
    GltfFile file = wheel(onlyTriangle + R"(,"indices":2)" + more);
    file.addData<std::uint16_t>("SCALAR", indices);
    return file.text();
}

/// The wheel with TEXCOORD_0 in accessor 2.
template <typename AddAccessor>
std::string wheelWithTexcoords(const AddAccessor& addAccessor) {
    GltfFile file = wheel(R"("attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2})");
    addAccessor(file);
    return file.text();
}

std::string wheelWithSparse(const std::vector<std::uint8_t>& indices, const std::string& count) {
    return wheelWithTexcoords([&](GltfFile& file) {
        const std::string indexView = std::to_string(file.addView(indices));
        const std::string valueView = std::to_string(file.addView(Bytes(16)));
        file.addAccessor(-1, "VEC2", 5126, 3,
                         R"("sparse":{"count":)" + count + R"(,"indices":{"bufferView":)" + indexView +
                             R"(,"componentType":5121},"values":{"bufferView":)" + valueView + "}}");
    });
}

std::string animationFile(const std::vector<float>& times, std::size_t values, const std::string& path,
                          const std::string& node = "{}") {
    GltfFile file;
    file.addData<float>("SCALAR", times);
    file.addData<float>("VEC3", std::vector<float>(values * 3, 1.0f));
    file.add("nodes", node);
    file.add("animations", R"({"name":"walk","samplers":[{"input":0,"output":1}],"channels":[{"sampler":0,
                              "target":{"node":0,"path":")" +
                               path + "\"}}]}");
    return file.text();
}

std::string withMaterial(const std::string& material) {
    return document(R"("materials":[)" + material + "]");
}

std::string withLight(const std::string& light) {
    return document(R"("nodes":[{"extensions":{"KHR_lights_punctual":{"light":0}}}],"extensions":
                       {"KHR_lights_punctual":{"lights":[)" +
                    light + "]}}");
}

std::string withSampler(const std::string& sampler) {
    return document(R"("images":[{"uri":"data:image/png;base64,)" + base64(makePng(1, 1, 1, 2, 3, 4)) +
                    R"("}],"samplers":[)" + sampler + R"(],"textures":[{"source":0,"sampler":0}],
                    "materials":[{"normalTexture":{"index":0}}])");
}

std::vector<Case> brokenDocuments() {
    return {
        {"empty", "", {"JSON"}},
        {"notJson", "{\"asset\":", {"JSON", "line 1"}},
        {"array", "[]", {"JSON", "not an object"}},
        {"badUtf8", "{\"asset\":\"\xFF\"}", {"JSON"}},
        {"hugeNumber", document(R"("nodes":[{"translation":[1e999,0,0]}])"), {"JSON"}},
        {"noAsset", "{}", {"asset", "missing"}},
        {"noVersion", R"({"asset":{}})", {"asset", "version"}},
        {"oldVersion", R"({"asset":{"version":"1.0"}})", {"asset", "1.0", "expected 2.0"}},
        {"oddVersion", R"({"asset":{"version":"two"}})", {"asset", "'two'"}},
        {"laterMinimum", R"({"asset":{"version":"2.1","minVersion":"2.1"}})", {"asset", "minVersion 2.1"}},
        {"requiredExtension",
         document(R"("extensionsRequired":["KHR_draco_mesh_compression"])"),
         {"extensionsRequired", "KHR_draco_mesh_compression"}},
        {"nodesNotAnArray", document(R"("nodes":{})"), {"nodes", "expected an array"}},
        {"nodeNotAnObject", document(R"("nodes":[1])"), {"node 0", "not an object"}},
        {"nameNotAString", document(R"("nodes":[{"name":3}])"), {"node 0", "name", "expected a string"}},
        {"sceneIndex", document(R"("scene":2,"scenes":[{}])"), {"scene 2 does not exist"}},
    };
}

std::vector<Case> brokenNodes() {
    return {
        {"childIndex",
         document(R"("nodes":[{"name":"hub","children":[7]}])"),
         {"node 0 'hub', children", "node 7 does not exist"}},
        {"negativeIndex", document(R"("nodes":[{"mesh":-1}])"), {"node 0, mesh", "mesh -1 does not exist"}},
        {"fractionalIndex", document(R"("nodes":[{"children":[0.5]}])"), {"node 0, children", "index"}},
        {"largeIndex", document(R"("nodes":[{"children":[4294967296]}])"), {"node 4294967296"}},
        {"ownChild", document(R"("nodes":[{"name":"hub","children":[0]}])"), {"node 0 'hub'", "cycle"}},
        {"cycle", document(R"("nodes":[{"children":[1]},{"children":[0]}])"), {"node 0", "cycle"}},
        {"twoParents",
         document(R"("nodes":[{"children":[2]},{"children":[2]},{"name":"hub"}])"),
         {"node 2 'hub'", "two parents", "0 and 1"}},
        {"sceneOfAChild",
         document(R"("nodes":[{"children":[1]},{}],"scenes":[{"nodes":[1]}])"),
         {"scene 0", "node 1 is not a root"}},
        {"sceneTwice", document(R"("nodes":[{}],"scenes":[{"nodes":[0,0]}])"), {"scene 0", "twice"}},
        {"shortVector",
         document(R"("nodes":[{"translation":[1,2]}])"),
         {"node 0, translation", "has 2 numbers, expected 3"}},
        {"notANumber", document(R"("nodes":[{"scale":[1,2,"x"]}])"), {"node 0, scale", "number"}},
        {"beyondFloat", document(R"("nodes":[{"scale":[1,2,1e39]}])"), {"node 0, scale", "1e+39"}},
        {"zeroRotation", document(R"("nodes":[{"rotation":[0,0,0,0]}])"), {"node 0", "rotation"}},
        {"projection",
         document(R"("nodes":[{"matrix":[1,0,0,0,0,1,0,0,0,0,1,1,0,0,0,0]}])"),
         {"node 0", "not affine"}},
        {"matrixAndTransform",
         document(R"("nodes":[{"scale":[1,1,1],"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}])"),
         {"node 0", "both a matrix"}},
        {"largeFov",
         document(R"("nodes":[{"camera":0}],"cameras":[{"name":"eye","type":"perspective",
                  "perspective":{"yfov":3.2,"znear":1}}])"),
         {"camera 0 'eye'", "yfov", "3.2"}},
        {"nearPlane",
         document(R"("cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0}}])"),
         {"camera 0, perspective, znear", "more than 0"}},
        {"cameraType", document(R"("cameras":[{"type":"fisheye"}])"), {"fisheye"}},
        {"lightType", withLight(R"({"name":"sky","type":"area"})"), {"light 0 'sky'", "area"}},
        {"lightCone",
         withLight(R"({"type":"spot","spot":{"innerConeAngle":0.5,"outerConeAngle":0.5}})"),
         {"light 0", "innerConeAngle"}},
        {"wideCone",
         withLight(R"({"type":"spot","spot":{"outerConeAngle":2}})"),
         {"light 0, spot, outerConeAngle", "is 2"}},
        {"negativeIntensity",
         withLight(R"({"type":"point","intensity":-1})"),
         {"light 0, intensity", "0 or more"}},
        {"lightRange", withLight(R"({"type":"point","range":0})"), {"light 0, range", "more than 0"}},
        {"lightIndex",
         document(R"("nodes":[{"extensions":{"KHR_lights_punctual":{"light":3}}}])"),
         {"node 0, KHR_lights_punctual, light", "light 3 does not exist"}},
    };
}

std::vector<Case> brokenMeshes() {
    return {
        {"noPrimitives", document(R"("meshes":[{"name":"wheel"}])"), {"mesh 0 'wheel'", "primitives"}},
        {"noAttributes",
         document(R"("meshes":[{"primitives":[{}]}])"),
         {"mesh 0, primitive 0", "attributes"}},
        {"mode",
         wheel(onlyTriangle + R"(,"mode":7)").text(),
         {"mesh 0 'wheel', primitive 0, mode", "0 to 6"}},
        {"material",
         wheel(onlyTriangle + R"(,"material":0)").text(),
         {"mesh 0 'wheel', primitive 0, material", "material 0 does not exist"}},
        {"attributeIndex",
         wheel(R"("attributes":{"POSITION":0,"NORMAL":9})").text(),
         {"mesh 0 'wheel', primitive 0, attribute NORMAL", "accessor 9 does not exist: the file has 2"}},
        {"attributeCount",
         wheelWithTexcoords([](GltfFile& f) {
             f.addData<float>("VEC2", {1, 2});
         }),
         {"mesh 0 'wheel', primitive 0, attribute TEXCOORD_0", "accessor 2 has 1 elements, expected 3"}},
        {"attributeType",
         wheelWithTexcoords([](GltfFile& f) { f.addData<float>("VEC3", std::vector<float>(9)); }),
         {"attribute TEXCOORD_0",
          "accessor 2 is VEC3 of FLOAT, expected VEC2 of FLOAT, normalised UNSIGNED_BYTE"}},
        {"unknownComponentType",
         wheelWithTexcoords([](GltfFile& f) { f.addAccessor(0, "VEC2", 5130, 3); }),
         {"attribute TEXCOORD_0", "component type 5130"}},
        {"quantizedWithoutExtension",
         wheelWithTexcoords([](GltfFile& f) {
             f.addData<std::uint16_t>("VEC2", {1, 2, 3, 4, 5, 6});
         }),
         {"attribute TEXCOORD_0", "VEC2 of UNSIGNED_SHORT"}},
        {"matrixType",
         wheelWithTexcoords([](GltfFile& f) { f.addAccessor(0, "MAT2", 5126, 1); }),
         {"accessor 2"}},
        {"accessorType",
         wheelWithTexcoords([](GltfFile& f) { f.addAccessor(0, "VEC5", 5126, 3); }),
         {"VEC5"}},
        {"beyondView",
         wheelWithTexcoords([](GltfFile& f) { f.addAccessor(0, "VEC2", 5126, 3, R"("byteOffset":16)"); }),
         {"attribute TEXCOORD_0", "accessor 2", "end at byte 40 of a bufferView of 36"}},
        {"hugeOffset",
         wheelWithTexcoords(
             [](GltfFile& f) { f.addAccessor(0, "VEC2", 5126, 3, R"("byteOffset":9007199254740992)"); }),
         {"attribute TEXCOORD_0", "accessor 2"}},
        {"maximumOffset",
         wheelWithTexcoords(
             [](GltfFile& f) { f.addAccessor(0, "VEC2", 5126, 3, R"("byteOffset":18446744073709551615)"); }),
         {"accessor 2, byteOffset"}},
        {"hugeCount",
         wheelWithTexcoords([](GltfFile& f) { f.addAccessor(0, "VEC2", 5126, 1u << 31); }),
         {"attribute TEXCOORD_0"}},
        {"hugeZeros",
         [] {
             GltfFile file;
             file.addAccessor(-1, "VEC3", 5126, 4000000000u);
             file.addMeshNode(R"("attributes":{"POSITION":0})");
             return file.text();
         }(),
         {"mesh 0, primitive 0, attribute POSITION", "accessor 0 has no bufferView and 4000000000 elements"}},
        {"notFinite",
         wheelWithTexcoords([](GltfFile& f) {
             f.addData<float>("VEC2", {0, 0, 0, std::nanf(""), 0, 0});
         }),
         {"attribute TEXCOORD_0", "accessor 2 has a number in element 1 that is not finite"}},
        {"stride",
         wheelWithTexcoords(
             [](GltfFile& f) { f.addAccessor(f.addView(Bytes(64), R"("byteStride":4)"), "VEC2", 5126, 3); }),
         {"attribute TEXCOORD_0", "byteStride of 4"}},
        {"oddStride",
         document(R"("buffers":[{"byteLength":1,"uri":"data:,A"}],
                               "bufferViews":[{"buffer":0,"byteLength":1,"byteStride":256}])"),
         {"bufferView 0, byteStride", "4 to 252"}},
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
        {"sparseOrder",
         wheelWithSparse({1, 1}, "2"),
         {"attribute TEXCOORD_0", "sparse index 1 at position 1"}},
        {"sparseRange", wheelWithSparse({0, 3}, "2"), {"sparse index 3 at position 1"}},
        {"sparseCount", wheelWithSparse({0, 1}, "3"), {"accessor 2", "sparse indices that end at byte 3"}},
        {"sparseNegative", wheelWithSparse({0, 1}, "-1"), {"accessor 2, sparse, count"}},
    };
}

std::vector<Case> brokenData() {
    const std::string view = R"("bufferViews":[{"buffer":0,"byteOffset":4,"byteLength":8}],"accessors":
        [{"bufferView":0,"type":"VEC3","componentType":5126,"count":1}],"meshes":[{"primitives":
        [{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}])";
    return {
        {"noUri", document(R"("buffers":[{"byteLength":4}])"), {"buffer 0", "has no URI"}},
        {"shortBuffer",
         document(R"("buffers":[{"name":"b","byteLength":4,"uri":"data:;base64,AAAA"}])"),
         {"buffer 0 'b'", "holds 3 bytes, expected byteLength = 4"}},
        {"zeroLength", document(R"("buffers":[{"byteLength":0,"uri":"data:,"}])"), {"buffer 0, byteLength"}},
        {"negativeLength",
         document(R"("buffers":[{"byteLength":-4,"uri":"data:,"}])"),
         {"buffer 0, byteLength", "-4"}},
        {"badBase64",
         document(R"("buffers":[{"byteLength":3,"uri":"data:;base64,A*AA"}])"),
         {"buffer 0", "character 1"}},
        {"cutBase64",
         document(R"("buffers":[{"byteLength":3,"uri":"data:;base64,AAAAA"}])"),
         {"buffer 0", "cut off"}},
        {"badPercent", document(R"("buffers":[{"byteLength":3,"uri":"a%2"}])"), {"buffer 0", "hexadecimal"}},
        {"zeroInUri", document(R"("buffers":[{"byteLength":3,"uri":"a%00b"}])"), {"buffer 0", "zero"}},
        {"emptyUri", document(R"("buffers":[{"byteLength":3,"uri":""}])"), {"buffer 0", "empty"}},
        {"viewBeyondBuffer",
         document(R"("buffers":[{"byteLength":9,"uri":"data:;base64,AAAAAAAAAAAA"}],)" + view),
         {"mesh 0, primitive 0, attribute POSITION", "bufferView 0 ends at byte 12, but buffer 0 has 9"}},
        {"imageIndex",
         document(R"("textures":[{"source":0}])"),
         {"texture 0, source", "image 0 does not exist"}},
        {"imageWithNothing",
         document(
             R"("images":[{"name":"i"}],"textures":[{"source":0}],
                      "materials":[{"normalTexture":{"index":0}}])"),
         {"image 0 'i'", "neither"}},
        {"textureIndex",
         withMaterial(R"({"name":"m","normalTexture":{"index":3}})"),
         {"material 0 'm', normalTexture, index", "texture 3 does not exist"}},
        {"baseColor",
         withMaterial(R"({"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,1.5]}})"),
         {"material 0, pbrMetallicRoughness, baseColorFactor", "is 1.5, expected 0 to 1"}},
        {"alphaMode", withMaterial(R"({"alphaMode":"GLOW"})"), {"material 0", "GLOW"}},
        {"doubleSided", withMaterial(R"({"doubleSided":1})"), {"material 0, doubleSided", "true or false"}},
        {"wrap", withSampler(R"({"wrapS":1})"), {"sampler 0", "wrap mode 1"}},
        {"minFilter", withSampler(R"({"minFilter":1})"), {"sampler 0", "minFilter 1"}},
        {"magFilter", withSampler(R"({"magFilter":9987})"), {"sampler 0", "magFilter 9987"}},
        {"animationTimes",
         animationFile({0, 2, 1}, 3, "scale"),
         {"animation 0 'walk', channel 0, input", "time 2"}},
        {"animationCount",
         animationFile({0, 1, 2}, 2, "scale"),
         {"animation 0 'walk', channel 0, output", "accessor 1 has 2 elements, expected 3"}},
        {"animationPath", animationFile({0}, 1, "colour"), {"animation 0 'walk', channel 0", "colour"}},
        {"animationType",
         animationFile({0}, 1, "rotation"),
         {"channel 0, output", "VEC3 of FLOAT, expected VEC4"}},
        {"animatedMatrix",
         animationFile({0}, 1, "scale", R"({"name":"hub","matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]})"),
         {"animation 0 'walk', channel 0", "node 0 'hub' has a matrix"}},
        {"animationSampler",
         document(R"("nodes":[{}],"animations":[{"samplers":[],"channels":[{"sampler":0,
                  "target":{"node":0,"path":"scale"}}]}])"),
         {"animation 0, channel 0", "sampler 0 does not exist"}},
    };
}

void expectErrors(const std::vector<Case>& cases) {
    for (const Case& test : cases) {
        const std::string error = errorOfText(test.text);
        EXPECT_FALSE(error.empty()) << test.name << " was accepted";
        EXPECT_NE(error.find("scene.gltf: "), std::string::npos) << test.name << ": " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << test.name << ": " << error;
        for (const std::string& part : test.parts) {
            EXPECT_NE(error.find(part), std::string::npos)
                << test.name << ": '" << part << "' is not in: " << error;
        }
    }
}

TEST(BrokenFile, document) {
    expectErrors(brokenDocuments());
}
TEST(BrokenFile, nodes) {
    expectErrors(brokenNodes());
}
TEST(BrokenFile, meshes) {
    expectErrors(brokenMeshes());
}
TEST(BrokenFile, data) {
    expectErrors(brokenData());
}

/// A .glb of the triangle with one 32-bit number overwritten.
Bytes glbWith(std::size_t offset, std::uint32_t value) {
    Bytes glb = triangleFile().glb();
    std::memcpy(&glb[offset], &value, sizeof value);
    return glb;
}

TEST(BrokenFile, glb) {
    const auto size = static_cast<std::uint32_t>(triangleFile().glb().size());
    std::uint32_t jsonSize = 0;
    const Bytes whole = triangleFile().glb();
    std::memcpy(&jsonSize, &whole[12], sizeof jsonSize);
    const std::pair<Bytes, const char*> cases[] = {
        {glbWith(4, 1), "container version 1, expected 2"},
        {glbWith(8, size + 1), "the header says"},
        {glbWith(8, 4), "the header says 4 bytes"},
        {glbWith(12, 0xFFFFFFFC), "chunk 0 has a length of 4294967292 bytes"},
        {glbWith(12, 3), "not a multiple of 4"},
        {glbWith(16, 0), "chunk 0 is not of type JSON"},
        // Eight bytes too many: as many as the header of the chunk has.
        {glbWith(20 + jsonSize, size - 20 - jsonSize), "chunk 1 has a length of"},
        {glbWith(24 + jsonSize, 0), "buffer 0: has no URI, and the file has no BIN chunk"},
        {Bytes(whole.begin(), whole.begin() + 8), "cut off within its header"},
    };
    for (const auto& [glb, part] : cases) {
        const std::string error = errorOfGlb(glb);
        EXPECT_NE(error.find(part), std::string::npos) << "'" << part << "' is not in: " << error;
    }
}

TEST(BrokenFile, deepNestingDoesNotCrash) {
    const std::string deep(200000, '[');
    EXPECT_NE(errorOfText(R"({"asset":{"version":"2.0"},"extras":)" + deep), "");
    const std::string closed = deep + std::string(deep.size(), ']');
    EXPECT_EQ(errorOfText(R"({"asset":{"version":"2.0"},"extras":)" + closed + "}"), "");
    EXPECT_NE(errorOfText(R"({"asset":{"version":"2.0"},"nodes":)" + closed + "}"), "");
}

}  // namespace
}  // namespace candela_test
