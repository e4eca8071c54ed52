// What becomes of files against the specification: the values that repaired parts get, and what stays of the
// rest.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "loading.h"

namespace candela_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::vector<std::string> namesOf(const candela::Scene& scene) {
    std::vector<std::string> names;
    for (const candela::Node& node : scene.nodes) names.push_back(node.name);
    return names;
}

candela::ImportedScene loadNodes(const std::vector<std::string>& nodes, const std::string& roots = "") {
    GltfFile file;
    for (const std::string& node : nodes) file.add("nodes", node);
    if (!roots.empty()) file.add("scenes", R"({"nodes":[)" + roots + "]}");
    return load(file);
}

TEST(Tolerance, aNodeWithTwoParentsIsDrawnUnderTheFirst) {
    const candela::Scene scene =
        loadNodes({R"({"name":"a","children":[2]})", R"({"name":"b","children":[2]})", R"({"name":"c"})"})
            .scene;
    EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"a", "c", "b"}));
    EXPECT_EQ(scene.nodes[1].parent, 0u);
}

TEST(Tolerance, aRootThatIsAChildIsDrawnAsTheChild) {
    const std::vector<std::string> nodes{R"({"name":"a","children":[1]})", R"({"name":"b","children":[2]})",
                                         R"({"name":"c"})"};
    for (const char* roots : {"0,1", "1,0", "0,2", "2,1,0", "1,2,0"}) {
        const candela::Scene scene = loadNodes(nodes, roots).scene;
        EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"a", "b", "c"})) << roots;
        EXPECT_EQ(scene.nodes.at(1).parent, 0u) << roots;
        EXPECT_EQ(scene.nodes.at(2).parent, 1u) << roots;
    }
}

TEST(Tolerance, aCycleIsCutWhereItCloses) {
    for (const char* roots : {"", "0", "0,1"}) {
        const candela::Scene scene =
            loadNodes({R"({"name":"a","children":[1]})", R"({"name":"b","children":[0]})"}, roots).scene;
        EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"a", "b"})) << roots;
        EXPECT_EQ(scene.nodes.at(1).parent, 0u);
    }
}

TEST(Tolerance, placesThatAreNoneAreLeftOut) {
    const candela::Scene scene = loadNodes({R"({"translation":[1e30,0,0],"scale":[2,2,2]})",
                                            R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,1e20,0,0,1]})"})
                                     .scene;
    const auto& transform = std::get<candela::Transform>(scene.nodes.at(0).transform);
    EXPECT_EQ(transform.translation, glm::vec3(0));
    EXPECT_EQ(transform.scale, glm::vec3(2));
    EXPECT_EQ(candela::worldTransforms(scene).at(1), glm::mat4(1));
}

TEST(Tolerance, aSceneThatIsNoneLeavesAllNodes) {
    GltfFile file = triangleFile();
    file.add("scenes", "7");
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(candela::triangleCount(imported.scene), 1u);
    EXPECT_TRUE(hasNote(imported, "scene 0: is not an object"));
}

TEST(Tolerance, rotationsAreBroughtToUnitLength) {
    const candela::Scene scene =
        loadNodes({R"({"rotation":[0,0,2,0]})", R"({"rotation":[0,0,0,0]})", R"({"rotation":["x",0,0,1]})"})
            .scene;
    EXPECT_EQ(std::get<candela::Transform>(scene.nodes[0].transform).rotation, glm::quat(0, 0, 0, 1));
    EXPECT_EQ(std::get<candela::Transform>(scene.nodes[1].transform).rotation, glm::quat(1, 0, 0, 0));
    EXPECT_EQ(std::get<candela::Transform>(scene.nodes[2].transform).rotation, glm::quat(1, 0, 0, 0));
}

candela::ImportedScene loadLight(const std::string& light) {
    GltfFile file;
    file.add("nodes", R"({"extensions":{"KHR_lights_punctual":{"light":0}}})");
    file.set("extensions", R"({"KHR_lights_punctual":{"lights":[)" + light + "]}}");
    return load(file);
}

TEST(Tolerance, coneAnglesOfAHardEdge) {
    for (const char* inner : {"0.5", "0.50000003", "0.7"}) {
        const candela::Light light =
            loadLight(std::string(R"({"type":"spot","spot":{"outerConeAngle":0.5,"innerConeAngle":)") +
                      inner + "}}")
                .scene.lights.at(0);
        EXPECT_EQ(light.outerConeAngle, 0.5f);
        EXPECT_EQ(light.innerConeAngle, std::nextafter(0.5f, 0.0f));
    }
}

TEST(Tolerance, aBrokenLightLeavesTheOthers) {
    GltfFile file;
    for (const char* light : {"0", "1", "2"})
        file.add("nodes", R"({"extensions":{"KHR_lights_punctual":{"light":)" + std::string(light) + "}}}");
    file.set("extensions",
             R"({"KHR_lights_punctual":{"lights":[{"type":"area"},7,{"type":"point","name":"lamp"}]}})");
    const candela::ImportedScene imported = load(file);
    ASSERT_EQ(imported.scene.lights.size(), 1u);
    EXPECT_EQ(imported.scene.lights[0].name, "lamp");
    EXPECT_TRUE(hasNote(imported, "light 0, type: is 'area', expected point, spot or directional"));
    EXPECT_TRUE(hasNote(imported, "light 1: is not an object"));
}

TEST(Tolerance, aBrokenMaterialIsTheDefaultOneAndKeepsItsIndex) {
    GltfFile file = triangleFile(R"("material":1)");
    file.add("materials", "[]");
    file.add("materials",
             R"({"name":"m","pbrMetallicRoughness":{"roughnessFactor":"x","metallicFactor":0.25}})");
    const candela::Scene scene = load(file).scene;
    EXPECT_EQ(scene.materials.at(1).roughness, 1.0f);
    EXPECT_EQ(scene.materials.at(1).metallic, 0.25f);
    EXPECT_EQ(scene.meshes.at(0).submeshes.at(0).material, 1u);
}

TEST(Tolerance, primitivesWithoutAMaterialShareTheDefaultOne) {
    GltfFile file = triangleFile();
    file.addMeshNode(R"("attributes":{"POSITION":0},"material":0)");
    file.addMeshNode(R"("attributes":{"POSITION":0},"material":9)");
    file.add("materials", R"({"name":"m"})");
    const candela::Scene scene = load(file).scene;
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[1].metallic, 1.0f);
    EXPECT_EQ(scene.materials[1].roughness, 1.0f);
    EXPECT_EQ(scene.materials[1].baseColor, glm::vec4(1));
    EXPECT_EQ(scene.meshes.at(0).submeshes.at(0).material, 1u);
    EXPECT_EQ(scene.meshes.at(1).submeshes.at(0).material, 0u);
    EXPECT_EQ(scene.meshes.at(2).submeshes.at(0).material, 1u);
}

TEST(Tolerance, directionsThatAreNotFiniteAreReplaced) {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
    file.addData<float>("VEC3", {nan, 0, 1, 0, 0, 0, 0, 0, 5});
    file.addData<float>("VEC4", {1, 0, 0, 1, 0, nan, 0, 1, 0, 0, 0, 1});
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1,"TANGENT":2})");
    const candela::ImportedScene imported = load(file);
    const candela::Mesh& mesh = imported.scene.meshes.at(0);
    EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)));
    EXPECT_TRUE(hasNote(imported, "mesh 0: normals of length 0 or not finite"));
    EXPECT_TRUE(hasNote(imported, "mesh 0: tangents of length 0 or not finite"));
}

TEST(Tolerance, trianglesWithBrokenVerticesAreLeftOut) {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, nan, 0, 0, 0, 1e30f, 0});
    file.addData<std::uint16_t>("SCALAR", {0, 1, 2, 0, 1, 3, 2, 1, 0, 9, 1, 2, 0, 1, 4});
    file.addMeshNode(R"("attributes":{"POSITION":0},"indices":1)");
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(candela::triangleCount(imported.scene), 2u);
    EXPECT_TRUE(hasNote(
        imported, "mesh 0, primitive 0: triangles with a vertex that is not finite or beyond 1e9: left out"));
    EXPECT_TRUE(
        hasNote(imported, "mesh 0, primitive 0: triangles with a vertex that does not exist: left out"));
}

TEST(Tolerance, integersThatLackWhatAllowsThemAreReadAllTheSame) {
    GltfFile file;
    file.addData<std::int16_t>("VEC3", {0, 0, 0, 8, 0, 0, 0, 4, 0});
    file.addData<std::uint8_t>("VEC3", {255, 0, 51, 255, 0, 51, 255, 0, 51});
    file.addData<std::uint8_t>("SCALAR", {0, 1, 2}, R"("normalized":true)");
    file.addMeshNode(R"("attributes":{"POSITION":0,"COLOR_0":1},"indices":2)");
    const candela::ImportedScene imported = load(file);
    const candela::Mesh& mesh = imported.scene.meshes.at(0);
    EXPECT_EQ(mesh.positions.at(1), glm::vec3(8, 0, 0));
    EXPECT_EQ(glm::vec2(mesh.colors.at(0)), glm::vec2(1, 0));
    EXPECT_FLOAT_EQ(mesh.colors.at(0).z, 0.2f);
    EXPECT_TRUE(hasNote(imported, "mesh 0: integers in POSITION without KHR_mesh_quantization"));
    EXPECT_TRUE(hasNote(imported, "mesh 0: integers in COLOR_0 without \"normalized\""));
}

TEST(Tolerance, aPathInPlaceOfAUri) {
    const std::pair<const char*, const char*> files[] = {
        {R"(data\\a b.bin)", "data/a b.bin"}, {"100%.bin", "100%.bin"}, {"a%20b.bin", "a%20b.bin"}};
    for (const auto& [uri, name] : files) {
        const TemporaryFolder folder;
        folder.write(name, triangleFile().binary());
        const candela::ImportedScene imported =
            loadPath(folder.write("a.gltf", triangleFile().textWithBufferFile(uri)));
        EXPECT_EQ(candela::triangleCount(imported.scene), 1u) << uri;
        EXPECT_TRUE(hasNote(imported, "buffer 0: a path in place of a URI")) << uri;
    }
}

TEST(Tolerance, aBrokenPrimitiveLeavesTheOthersOfItsMesh) {
    GltfFile file;
    addTriangle(file);
    file.add("meshes", R"({"name":"wheel","primitives":[{"attributes":{"POSITION":7}},
        {"attributes":{"POSITION":0,"NORMAL":1}},{"attributes":{"POSITION":0},"indices":1}]})");
    file.add("nodes", R"({"mesh":0})");
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(candela::triangleCount(imported.scene), 1u);
    EXPECT_TRUE(
        hasNote(imported, "mesh 0 'wheel', primitive 0, attribute POSITION: accessor 7 does not exist"));
    EXPECT_TRUE(hasNote(imported, "mesh 0 'wheel', primitive 2, indices: accessor 1 is VEC3 of FLOAT"));
}

TEST(Tolerance, aMissingBufferLeavesWhatDoesNotReadIt) {
    GltfFile file = triangleFile();
    file.add("buffers", R"({"byteLength":)" + std::to_string(file.binary().size()) +
                            R"(,"uri":"data:;base64,)" + base64(file.binary()) + "\"}");
    file.add("buffers", R"({"name":"walk","byteLength":12,"uri":"walk.bin"})");
    file.add("bufferViews", R"({"buffer":1,"byteLength":12})");
    const std::string times = std::to_string(file.addAccessor(2, "SCALAR", 5126, 1));
    const std::string values = std::to_string(file.addAccessor(2, "VEC3", 5126, 1));
    file.add("animations", R"({"samplers":[{"input":)" + times + R"(,"output":)" + values +
                               R"(}],"channels":[{"sampler":0,"target":{"node":0,"path":"scale"}}]})");
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(candela::triangleCount(imported.scene), 1u);
    EXPECT_TRUE(imported.scene.animations.empty());
    EXPECT_TRUE(
        hasNote(imported, "animation 0, channel 0, input: buffer 1 'walk': file 'walk.bin': No such file"));
}

TEST(Tolerance, anEmptyBufferViewHarmsNothing) {
    GltfFile file = triangleFile();
    file.add("bufferViews", R"({"buffer":0,"byteOffset":0,"byteLength":0})");
    EXPECT_TRUE(load(file).report.notes.empty());
}

TEST(Tolerance, viewsBehindTheByteLengthAreRead) {
    GltfFile file = triangleFile();
    file.add("buffers", R"({"byteLength":8,"uri":"data:;base64,)" + base64(file.binary()) + "\"}");
    EXPECT_EQ(candela::triangleCount(load(file).scene), 1u);
}

/// A node with x at each key, and the channel that is read.
candela::ImportedScene loadKeys(const std::vector<float>& times, const std::vector<float>& xs,
                                const std::string& interpolation) {
    GltfFile file;
    file.addData<float>("SCALAR", times);
    std::vector<float> values;
    for (const float x : xs) values.insert(values.end(), {x, 0, 0});
    file.addData<float>("VEC3", values);
    file.add("nodes", "{}");
    file.add("animations", R"({"samplers":[{"input":0,"output":1,"interpolation":)" + interpolation +
                               R"(}],"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}]})");
    return load(file);
}

std::vector<float> xsOf(const candela::AnimationChannel& channel) {
    std::vector<float> xs;
    for (std::size_t i = 0; i < channel.values.size(); i += 3) xs.push_back(channel.values[i]);
    return xs;
}

void expectKeys(const candela::ImportedScene& imported, const std::vector<float>& times,
                const std::vector<float>& xs) {
    const candela::AnimationChannel& channel = imported.scene.animations.at(0).channels.at(0);
    EXPECT_EQ(channel.times, times);
    EXPECT_EQ(xsOf(channel), xs);
    EXPECT_EQ(imported.report.notes.size(), 1u);
}

TEST(Tolerance, keyTimesAreSorted) {
    expectKeys(loadKeys({0, 2, 1}, {5, 7, 6}, R"("LINEAR")"), {0, 1, 2}, {5, 6, 7});
}

TEST(Tolerance, doubledKeyTimesAreAJump) {
    const float after = std::nextafter(1.0f, 2.0f);
    expectKeys(loadKeys({0, 1, 1, 2}, {5, 6, 8, 9}, R"("LINEAR")"), {0, 1, after, 2}, {5, 6, 8, 9});
}

TEST(Tolerance, keyTimesBeforeZeroGiveWayToOneAtZero) {
    expectKeys(loadKeys({-2, -1, 3}, {5, 6, 10}, R"("LINEAR")"), {0, 3}, {7, 10});
    expectKeys(loadKeys({-2, -1, 3}, {5, 6, 10}, R"("STEP")"), {0, 3}, {6, 10});
    expectKeys(loadKeys({-2, -1}, {5, 6}, R"("LINEAR")"), {0}, {6});
    expectKeys(loadKeys({-1, 0, 3}, {5, 6, 10}, R"("LINEAR")"), {0, 3}, {6, 10});
}

TEST(Tolerance, anInterpolationThatIsANumberIsLinear) {
    const candela::ImportedScene imported = loadKeys({0, 1}, {5, 6}, "9729");
    EXPECT_EQ(imported.scene.animations.at(0).channels.at(0).interpolation, candela::Interpolation::linear);
    EXPECT_TRUE(
        hasNote(imported, "animation 0, sampler 0, interpolation: expected a string: the default is used"));
}

TEST(Tolerance, aBrokenChannelLeavesTheOthers) {
    GltfFile file;
    file.addData<float>("SCALAR", {0});
    file.addData<float>("VEC3", {1, 2, 3});
    file.add("nodes", "{}");
    file.add("animations", R"({"samplers":[{"input":0,"output":1},{"input":1,"output":1},8],"channels":[
        {"sampler":1,"target":{"node":0,"path":"scale"}},{"sampler":2,"target":{"node":0,"path":"scale"}},
        4,{"sampler":0,"target":{"node":0,"path":"translation"}}]})");
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(imported.scene.animations.at(0).channels.size(), 1u);
    EXPECT_TRUE(hasNote(imported, "animation 0, channel 0, input: accessor 1 is VEC3"));
    EXPECT_TRUE(hasNote(imported, "animation 0, sampler 2 and 1 more: is not an object: left out"));
}

TEST(Tolerance, anUnalignedChunkOfAGlb) {
    std::string json = triangleFile().textWithBufferFile("");
    const std::string member = R"(,"uri":"")";
    if (const auto at = json.find(member); at != json.npos) json.erase(at, member.size());
    while (json.size() % 4 != 1) json += ' ';
    for (const std::size_t padding : {0u, 3u}) {
        Bytes glb = makeGlb(json, triangleFile().binary());
        // makeGlb pads with three blanks; here the length of the chunk does not count them.
        const auto size = static_cast<std::uint32_t>(json.size());
        std::memcpy(&glb[12], &size, sizeof size);
        if (padding == 0) glb.erase(glb.begin() + 20 + size, glb.begin() + 23 + size);
        const candela::ImportedScene imported = loadGlb(glb);
        EXPECT_EQ(candela::triangleCount(imported.scene), 1u) << padding;
        EXPECT_TRUE(hasNote(imported, "chunk 0 has a length that is not a multiple of 4")) << padding;
    }
}

TEST(Tolerance, numbersThatJsonDoesNotHave) {
    const candela::ImportedScene imported = loadText(
        R"({"asset":{"version":"2.0"},"nodes":[{"name":"NaN, \"Infinity\"","scale":[1,NaN,-Infinity],"translation":[1,2,3]}]})");
    const auto& transform = std::get<candela::Transform>(imported.scene.nodes.at(0).transform);
    EXPECT_EQ(imported.scene.nodes[0].name, "NaN, \"Infinity\"");
    EXPECT_EQ(transform.scale, glm::vec3(1));
    EXPECT_EQ(transform.translation, glm::vec3(1, 2, 3));
    EXPECT_TRUE(hasNote(imported, "JSON: NaN"));
}

TEST(Tolerance, textThatIsNotUtf8AndZerosBehindIt) {
    const candela::ImportedScene imported =
        loadText(std::string("{\"asset\":{\"version\":2.0},\"nodes\":[{\"name\":\"M\xFCller\"}]}") +
                 std::string(3, '\0'));
    EXPECT_EQ(imported.scene.nodes.at(0).name, "M?ller");
    EXPECT_TRUE(hasNote(imported, "asset: version is a number"));
}

}  // namespace
}  // namespace candela_test
