#include <gtest/gtest.h>

#include <cmath>

#include "broken_files.h"
#include "image_files.h"

namespace candela_test {
namespace {

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

std::vector<Case> brokenNodes() {
    return {
        {"sceneIndex", document(R"("scene":2,"scenes":[{}])"), {"scene", "scene 2 does not exist"}},
        {"childIndex",
         document(R"("nodes":[{"name":"hub","children":[7]}])"),
         {"node 0 'hub', children", "node 7 does not exist"}},
        {"fractionalIndex", document(R"("nodes":[{"children":[0.5]}])"), {"node 0, children", "index"}},
        {"largeIndex", document(R"("nodes":[{"children":[4294967296]}])"), {"node 4294967296"}},
        {"ownChild",
         document(R"("nodes":[{"name":"hub","children":[0]}])"),
         {"node 0 'hub'", "own ancestor"}},
        {"cycle", document(R"("nodes":[{"children":[1]},{"children":[0]}])"), {"node 0", "own ancestor"}},
        {"twoParents",
         document(R"("nodes":[{"children":[2]},{"children":[2]},{"name":"hub"}])"),
         {"node 2 'hub'", "two parents"}},
        {"sceneTwice",
         document(R"("nodes":[{}],"scenes":[{"nodes":[0,0]}])"),
         {"node 0", "listed twice by scene 0"}},
        {"shortVector",
         document(R"("nodes":[{"translation":[1,2]}])"),
         {"node 0, translation", "has 2 numbers, expected 3"}},
        {"notANumber", document(R"("nodes":[{"scale":[1,2,"x"]}])"), {"node 0, scale", "number"}},
        {"beyondFloat", document(R"("nodes":[{"scale":[1,2,1e39]}])"), {"node 0, scale", "1e+39"}},
        {"zeroRotation", document(R"("nodes":[{"rotation":[0,0,0,0]}])"), {"node 0", "rotation"}},
        {"longRotation", document(R"("nodes":[{"rotation":[0,0,0,2]}])"), {"node 0", "rotation"}},
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
         document(
             R"("nodes":[{"camera":0}],"cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0}}])"),
         {"camera 0, perspective, znear", "more than 0"}},
        {"cameraType",
         document(R"("nodes":[{"camera":0}],"cameras":[{"type":"fisheye"}])"),
         {"camera 0, type", "fisheye"}},
        {"cameraWithoutPerspective",
         document(R"("nodes":[{"camera":0}],"cameras":[{"name":"eye","type":"perspective"}])"),
         {"camera 0 'eye'", "\"perspective\" is missing"}},
        {"cameraIndex", document(R"("nodes":[{"camera":1}])"), {"node 0, camera", "camera 1 does not exist"}},
        {"lightType", withLight(R"({"name":"sky","type":"area"})"), {"light 0 'sky', type", "area"}},
        {"lightWithoutType", withLight(R"({"name":"sky"})"), {"light 0 'sky'", "\"type\" is missing"}},
        {"noSpot", withLight(R"({"type":"spot"})"), {"light 0", "without \"spot\""}},
        {"wideCone",
         withLight(R"({"type":"spot","spot":{"outerConeAngle":2}})"),
         {"light 0, spot, outerConeAngle", "more than 1.57"}},
        {"reversedCone",
         withLight(R"({"type":"spot","spot":{"innerConeAngle":0.6,"outerConeAngle":0.5}})"),
         {"light 0, spot", "hard edge"}},
        {"darkCone",
         withLight(R"({"type":"spot","spot":{"outerConeAngle":0}})"),
         {"light 0, spot", "outerConeAngle is 0"}},
        {"negativeIntensity",
         withLight(R"({"type":"point","intensity":-1})"),
         {"light 0, intensity", "less than 0, clamped"}},
        {"colorNotNumbers",
         withLight(R"({"type":"point","color":"red"})"),
         {"light 0, color", "array of numbers"}},
        {"lightRange", withLight(R"({"type":"point","range":0})"), {"light 0, range", "more than 0"}},
        {"lightRadius",
         withLight(R"({"name":"sky","type":"point","extras":{"radius":"wide"}})"),
         {"light 0 'sky', extras, radius", "expected a number of 0 or more: the default is used"}},
        {"negativeRadius",
         withLight(R"({"type":"point","extras":{"radius":-0.5}})"),
         {"light 0, extras, radius", "0 or more"}},
        {"radiusBeyondFloat",
         withLight(R"({"type":"point","extras":{"radius":1e39}})"),
         {"light 0, extras, radius", "0 or more"}},
        {"lightShadow",
         withLight(R"({"type":"point","extras":{"castsShadow":"no"}})"),
         {"light 0, extras, castsShadow", "expected true or false: the default is used"}},
        {"nodeShadow",
         document(R"("nodes":[{"name":"hub","extras":{"castsShadow":2}}])"),
         {"node 0 'hub', extras, castsShadow", "expected true or false"}},
        {"lightIndex",
         document(R"("nodes":[{"extensions":{"KHR_lights_punctual":{"light":3}}}])"),
         {"node 0, KHR_lights_punctual, light", "light 3 does not exist"}},
    };
}

std::vector<Case> brokenMeshes() {
    return {
        {"material",
         wheel(onlyTriangle + R"(,"material":0)").text(),
         {"mesh 0 'wheel', primitive 0, material", "material 0 does not exist"}},
        {"otherPrimitive",
         withPrimitives(R"({"attributes":{"POSITION":0},"mode":9},{"attributes":{"POSITION":0}})"),
         {"mesh 0 'wheel', primitive 0, mode", "is 9", "left out"}},
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
         {"attribute TEXCOORD_0", "accessor 2, componentType", "is 5130, expected 5120 to 5126"}},
        {"quantizedWithoutExtension",
         wheelWithTexcoords([](GltfFile& f) {
             f.addData<std::uint16_t>("VEC2", {1, 2, 3, 4, 5, 6});
         }),
         {"mesh 0 'wheel'", "TEXCOORD_0 without KHR_mesh_quantization"}},
        {"matrixType",
         wheelWithTexcoords([](GltfFile& f) { f.addAccessor(0, "MAT2", 5126, 1); }),
         {"accessor 2"}},
        {"accessorType",
         wheelWithTexcoords([](GltfFile& f) { f.addAccessor(0, "VEC5", 5126, 3); }),
         {"accessor 2, type", "VEC5"}},
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
        {"texcoordNotFinite",
         wheelWithTexcoords([](GltfFile& f) {
             f.addData<float>("VEC2", {0, 0, 0, std::nanf(""), 0, 0});
         }),
         {"attribute TEXCOORD_0", "not finite, taken as 0"}},
        {"stride",
         wheelWithTexcoords(
             [](GltfFile& f) { f.addAccessor(f.addView(Bytes(64), R"("byteStride":4)"), "VEC2", 5126, 3); }),
         {"attribute TEXCOORD_0", "byteStride of 4"}},
        {"someIndices",
         wheelWithIndices({0, 1, 2, 0, 1, 3}),
         {"mesh 0 'wheel', primitive 0", "a vertex that does not exist"}},
        {"surplusIndex",
         wheelWithIndices({0, 1, 2, 0}),
         {"mesh 0 'wheel', primitive 0", "last whole triangle"}},
        {"sparseOrder",
         wheelWithSparse({1, 1}, "2"),
         {"attribute TEXCOORD_0", "sparse index 1 at position 1"}},
        {"sparseRange", wheelWithSparse({0, 3}, "2"), {"sparse index 3 at position 1"}},
        {"sparseCount", wheelWithSparse({0, 1}, "3"), {"accessor 2", "sparse indices that end at byte 3"}},
        {"sparseNegative", wheelWithSparse({0, 1}, "-1"), {"accessor 2, sparse, count"}},
    };
}

std::vector<Case> brokenData() {
    return {
        {"shortBuffer",
         document(R"("buffers":[{"name":"b","byteLength":4,"uri":"data:;base64,AAAA"}])"),
         {"buffer 0 'b'", "holds 3 bytes, expected byteLength = 4"}},
        {"negativeLength",
         document(R"("buffers":[{"byteLength":-4,"uri":"data:,"}])"),
         {"buffer 0, byteLength", "-4"}},
        {"imageIndex",
         document(R"("textures":[{"source":0}],"materials":[{"normalTexture":{"index":0}}])"),
         {"texture 0, source", "image 0 does not exist"}},
        {"imageWithNothing",
         document(
             R"("images":[{"name":"i"}],"textures":[{"source":0}],
                      "materials":[{"normalTexture":{"index":0}}])"),
         {"image 0 'i'", "neither"}},
        {"textureIndex",
         withMaterial(R"({"name":"m","normalTexture":{"index":3}})"),
         {"material 0 'm', normalTexture, index", "texture 3 does not exist"}},
        {"materialNotAnObject", withMaterial("7"), {"material 0", "not an object: the default is used"}},
        {"baseColor",
         withMaterial(R"({"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,1.5]}})"),
         {"material 0, pbrMetallicRoughness, baseColorFactor", "more than 1, clamped"}},
        {"negativeRoughness",
         withMaterial(R"({"pbrMetallicRoughness":{"roughnessFactor":-0.1}})"),
         {"material 0, pbrMetallicRoughness, roughnessFactor", "less than 0, clamped"}},
        {"factorOfNull",
         withMaterial(R"({"pbrMetallicRoughness":{"metallicFactor":null}})"),
         {"metallicFactor", "expected a number: the default is used"}},
        {"alphaMode", withMaterial(R"({"alphaMode":"GLOW"})"), {"material 0, alphaMode", "GLOW"}},
        {"doubleSided", withMaterial(R"({"doubleSided":1})"), {"material 0, doubleSided", "true or false"}},
        {"wrap", withSampler(R"({"wrapS":1})"), {"sampler 0", "wrapS 1"}},
        {"minFilter", withSampler(R"({"minFilter":1})"), {"sampler 0", "minFilter 1"}},
        {"magFilter", withSampler(R"({"magFilter":9987})"), {"sampler 0", "magFilter 9987"}},
        {"animationTimes",
         animationFile({0, 2, 1}, 3, "scale"),
         {"animation 0 'walk', channel 0", "do not increase"}},
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
        {"animationNode",
         document(R"("nodes":[{}],"animations":[{"samplers":[],"channels":[{"sampler":0,
                  "target":{"node":4,"path":"scale"}}]}])"),
         {"animation 0, channel 0, target, node", "node 4 does not exist"}},
        {"animationWithoutSamplers",
         document(R"("nodes":[{}],"animations":[{"name":"walk","channels":[]}])"),
         {"animation 0 'walk'", "\"samplers\" is missing"}},
        {"samplerInput",
         document(R"("nodes":[{}],"animations":[{"samplers":[{"input":3,"output":3}],"channels":[{"sampler":0,
                  "target":{"node":0,"path":"scale"}}]}])"),
         {"animation 0, sampler 0, input", "accessor 3 does not exist"}},
    };
}

TEST(BrokenFile, nodesAreRepairedOrLeftOut) {
    expectNotes(brokenNodes());
}
TEST(BrokenFile, partsOfMeshesAreLeftOut) {
    expectNotes(brokenMeshes());
}
TEST(BrokenFile, dataIsRepairedOrLeftOut) {
    expectNotes(brokenData());
}

TEST(BrokenFile, metadataIsNotNoted) {
    const candela::ImportedScene imported = loadText(R"({"asset":{"version":"2.0","generator":7},"extras":[],
        "nodes":[{"name":3,"extras":{"a":1}}],"extensionsUsed":["KHR_xmp","KHR_materials_variants"],
        "extensions":{"KHR_xmp":{"packets":[]},"KHR_materials_variants":{"variants":[{"name":"red"}]}}})");
    EXPECT_TRUE(imported.report.notes.empty());
}

}  // namespace
}  // namespace candela_test
