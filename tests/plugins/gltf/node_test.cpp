#include <gtest/gtest.h>

#include "loading.h"

namespace candela_test {
namespace {

GltfFile fileWithNodes(const std::vector<std::string>& nodes) {
    GltfFile file;
    for (const std::string& node : nodes) file.add("nodes", node);
    return file;
}

std::vector<std::string> namesOf(const candela::Scene& scene) {
    std::vector<std::string> names;
    for (const candela::Node& node : scene.nodes) names.push_back(node.name);
    return names;
}

TEST(Node, childTransformsAreRelativeToTheParent) {
    // The child comes before its parent in the file.
    const candela::Scene scene = load(fileWithNodes({R"({"name":"child","translation":[1,0,0]})",
                                                     R"({"name":"parent","scale":[2,2,2],"children":[0],
                                                         "rotation":[0,0.70710678,0,0.70710678]})"}))
                                     .scene;
    EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"parent", "child"}));
    EXPECT_EQ(scene.nodes[1].parent, 0u);
    const glm::vec4 position = candela::worldTransforms(scene)[1][3];
    // A rotation by 90 degrees about +Y maps +X to -Z. Tolerance: the quaternion has 8 digits.
    EXPECT_NEAR(position.x, 0.0f, 1e-6f);
    EXPECT_NEAR(position.z, -2.0f, 1e-6f);
}

TEST(Node, matrix) {
    const candela::Scene scene =
        load(fileWithNodes({R"({"matrix":[2,0,0,0, 0,3,0,0, 0,0,4,0, 5,6,7,1]})"})).scene;
    const glm::mat4 matrix = std::get<glm::mat4>(scene.nodes.at(0).transform);
    EXPECT_EQ(matrix[0][0], 2.0f);
    EXPECT_EQ(matrix[3], glm::vec4(5, 6, 7, 1));
}

TEST(Node, onlyTheDefaultSceneIsDrawn) {
    GltfFile file = fileWithNodes({R"({"name":"a"})", R"({"name":"b","children":[2]})", R"({"name":"c"})"});
    file.add("scenes", R"({"nodes":[0]})");
    file.add("scenes", R"({"nodes":[1]})");
    file.set("scene", "1");
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(namesOf(imported.scene), (std::vector<std::string>{"b", "c"}));
    EXPECT_TRUE(hasNote(imported, "scene 1 of 2 is drawn"));
}

TEST(Node, sceneZeroWithoutADefault) {
    GltfFile file = fileWithNodes({R"({"name":"a"})", R"({"name":"b"})"});
    file.add("scenes", R"({"nodes":[1]})");
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(namesOf(imported.scene), (std::vector<std::string>{"b"}));
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(Node, allRootsWithoutScenes) {
    EXPECT_EQ(namesOf(load(fileWithNodes({R"({"name":"a"})", R"({"name":"b"})"})).scene),
              (std::vector<std::string>{"a", "b"}));
}

TEST(Node, aChainOfTenThousandNodes) {
    GltfFile file;
    constexpr int length = 10000;
    for (int i = 0; i + 1 < length; ++i) {
        file.add("nodes", "{\"translation\":[1,0,0],\"children\":[" + std::to_string(i + 1) + "]}");
    }
    file.add("nodes", R"({"translation":[1,0,0]})");
    const candela::Scene scene = load(file).scene;
    ASSERT_EQ(scene.nodes.size(), static_cast<std::size_t>(length));
    EXPECT_EQ(candela::worldTransforms(scene).back()[3].x, static_cast<float>(length));
}

TEST(Node, keepsTheDigitsOfItsTranslation) {
    const GltfFile file = fileWithNodes(
        {R"({"translation":[4000000.3,-0.1,2]})", R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,4000000.3,0,0,1]})"});
    const candela::Scene scene = load(file).scene;
    const auto& placed = std::get<candela::Transform>(scene.nodes[0].transform);
    EXPECT_EQ(double{placed.translation.x} + scene.nodes[0].translationRemainder.x, 4000000.3);
    EXPECT_EQ(double{placed.translation.y} + scene.nodes[0].translationRemainder.y, -0.1);
    EXPECT_EQ(scene.nodes[0].translationRemainder.z, 0.0);
    EXPECT_NEAR(scene.nodes[1].translationRemainder.x, 0.05, 1e-9);
}

TEST(Camera, perspective) {
    GltfFile file =
        fileWithNodes({R"({"camera":0,"translation":[0,1,2]})", R"({"camera":1,"name":"above"})"});
    file.add("cameras",
             R"({"name":"front","type":"perspective","perspective":
                 {"yfov":0.5,"znear":0.25,"zfar":10,"aspectRatio":2}})");
    file.add("cameras", R"({"type":"perspective","perspective":{"yfov":1,"znear":0.5}})");
    const candela::Scene scene = load(file).scene;
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].name, "front");
    EXPECT_EQ(scene.cameras[0].verticalFov, 0.5f);
    EXPECT_EQ(scene.cameras[0].nearPlane, 0.25f);
    EXPECT_EQ(scene.cameras[0].farPlane, 10.0f);
    EXPECT_EQ(scene.cameras[0].node, 0u);
    EXPECT_EQ(scene.cameras[0].number, 0u);
    EXPECT_EQ(scene.cameras[1].name, "") << "its node is called above, which its index tells";
    EXPECT_EQ(scene.cameras[1].node, 1u);
}

TEST(Camera, hasItsNumberInTheFile) {
    GltfFile file = fileWithNodes({R"({"camera":2})", R"({"camera":0})", R"({"camera":2})"});
    for (int i = 0; i < 3; ++i)
        file.add("cameras", R"({"type":"perspective","perspective":{"yfov":0.5,"znear":0.25}})");
    const candela::Scene scene = load(file).scene;
    ASSERT_EQ(scene.cameras.size(), 3u);
    EXPECT_EQ(scene.cameras[0].number, 2u);
    EXPECT_EQ(scene.cameras[1].number, 0u);
    EXPECT_EQ(scene.cameras[2].number, 2u);
}

TEST(Camera, orthographic) {
    GltfFile file = fileWithNodes({R"({"camera":0})"});
    file.add("cameras", R"({"name":"map","type":"orthographic","orthographic":
                            {"xmag":1,"ymag":1.5,"zfar":10,"znear":0}})");
    const candela::Scene scene = load(file).scene;
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].name, "map");
    EXPECT_EQ(scene.cameras[0].orthographicHeight, 3.0f);
    EXPECT_FALSE(scene.cameras[0].nearPlane);
    EXPECT_EQ(scene.cameras[0].farPlane, 10.0f);
}

TEST(Camera, farPlaneBeforeTheNearOneIsLeftOut) {
    GltfFile file = fileWithNodes({R"({"camera":0})"});
    file.add("cameras", R"({"type":"perspective","perspective":{"yfov":1,"znear":2,"zfar":1}})");
    const candela::ImportedScene imported = load(file);
    ASSERT_EQ(imported.scene.cameras.size(), 1u);
    EXPECT_FALSE(imported.scene.cameras[0].farPlane);
    EXPECT_TRUE(hasNote(imported, "camera 0: zfar is not over znear: left out"));
}

GltfFile fileWithLights(const std::string& lights, int count) {
    GltfFile file;
    for (int i = 0; i < count; ++i) {
        file.add("nodes", R"({"name":"n)" + std::to_string(i) +
                              R"(","extensions":{"KHR_lights_punctual":{"light":)" + std::to_string(i) +
                              "}}}");
    }
    file.set("extensions", R"({"KHR_lights_punctual":{"lights":[)" + lights + "]}}");
    file.set("extensionsUsed", R"(["KHR_lights_punctual"])");
    return file;
}

TEST(Light, ofEveryType) {
    const candela::Scene scene = load(fileWithLights(R"(
        {"name":"lamp","type":"point","color":[1,0.5,0.25],"intensity":20,"range":5},
        {"type":"spot","intensity":3,"spot":{"innerConeAngle":0.125,"outerConeAngle":0.5}},
        {"type":"directional"})",
                                                     3))
                                     .scene;
    ASSERT_EQ(scene.lights.size(), 3u);
    const candela::Light &lamp = scene.lights[0], &spot = scene.lights[1], &sun = scene.lights[2];
    EXPECT_EQ(lamp.name, "lamp");
    EXPECT_EQ(lamp.type, candela::LightType::point);
    EXPECT_EQ(lamp.color, glm::vec3(1, 0.5f, 0.25f));
    EXPECT_EQ(lamp.intensity, 20.0f);
    EXPECT_EQ(lamp.range, 5.0f);
    EXPECT_EQ(lamp.node, 0u);
    EXPECT_EQ(spot.name, "n1") << "a light without a name gets its node's";
    EXPECT_EQ(spot.type, candela::LightType::spot);
    EXPECT_EQ(spot.innerConeAngle, 0.125f);
    EXPECT_EQ(spot.outerConeAngle, 0.5f);
    EXPECT_EQ(spot.direction, glm::vec3(0, 0, -1));
    EXPECT_FALSE(spot.range.has_value());
    EXPECT_EQ(sun.type, candela::LightType::directional);
    EXPECT_EQ(sun.color, glm::vec3(1));
    EXPECT_EQ(sun.intensity, 1.0f);
    EXPECT_EQ(sun.node, 2u);
}

TEST(Light, spotDefaults) {
    const candela::Light spot = load(fileWithLights(R"({"type":"spot","spot":{}})", 1)).scene.lights.at(0);
    EXPECT_EQ(spot.innerConeAngle, 0.0f);
    EXPECT_FLOAT_EQ(spot.outerConeAngle, 0.78539816f);
}

TEST(Light, sharedByTwoNodesIsTwoLights) {
    GltfFile file = fileWithLights(R"({"type":"point"})", 1);
    file.add("nodes", R"({"extensions":{"KHR_lights_punctual":{"light":0}}})");
    const candela::Scene scene = load(file).scene;
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[1].node, 1u);
}

TEST(Light, ofGltfCastsShadowsAndIsAPoint) {
    const candela::Light light = load(fileWithLights(R"({"type":"point"})", 1)).scene.lights.at(0);
    EXPECT_TRUE(light.castsShadow);
    EXPECT_EQ(light.radius, 0.0f);
}

TEST(Light, extrasSayWhetherItCastsShadowsAndItsRadius) {
    const candela::ImportedScene imported = load(fileWithLights(R"(
        {"type":"point","extras":{"castsShadow":false,"radius":0.25}},
        {"type":"spot","spot":{},"extras":{"castsShadow":true,"radius":0}},
        {"type":"directional","extras":{"castsShadow":0}},
        {"type":"point","extras":{"castsShadow":1,"radius":2}},
        {"type":"point","extras":[false]},
        {"type":"point","extras":7})",
                                                                6));
    const std::vector<candela::Light>& lights = imported.scene.lights;
    ASSERT_EQ(lights.size(), 6u);
    const bool casts[] = {false, true, false, true, true, true};
    const float radii[] = {0.25f, 0.0f, 0.0f, 2.0f, 0.0f, 0.0f};
    for (std::size_t i = 0; i < lights.size(); ++i) {
        EXPECT_EQ(lights[i].castsShadow, casts[i]) << i;
        EXPECT_EQ(lights[i].radius, radii[i]) << i;
    }
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(Light, extrasOfANodeWithoutAMeshAreThoseOfItsLight) {
    GltfFile file;
    addTriangle(file);
    file.add("meshes", R"({"primitives":[{"attributes":{"POSITION":0}}]})");
    const auto addNode = [&](const std::string& members, int light) {
        file.add("nodes", "{" + members + R"("extras":{"castsShadow":false},"extensions":{
            "KHR_lights_punctual":{"light":)" +
                              std::to_string(light) + "}}}");
    };
    addNode("", 0);
    addNode(R"("mesh":0,)", 0);
    addNode("", 1);
    file.set("extensions", R"({"KHR_lights_punctual":{"lights":[{"type":"point"},
                               {"type":"point","extras":{"castsShadow":true}}]}})");
    file.set("extensionsUsed", R"(["KHR_lights_punctual"])");
    const candela::Scene scene = load(file).scene;
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_FALSE(scene.lights[0].castsShadow);
    EXPECT_TRUE(scene.lights[1].castsShadow) << "a bulb that shadows nothing";
    EXPECT_FALSE(scene.nodes[1].castsShadow);
    EXPECT_TRUE(scene.lights[2].castsShadow) << "its own extras go first";
}

TEST(Node, extrasSayWhetherItCastsShadows) {
    GltfFile file;
    addTriangle(file);
    // Primitives of different attributes become meshes of their own, which children of the node show.
    file.add("meshes", R"({"primitives":[{"attributes":{"POSITION":0}},
                                         {"attributes":{"POSITION":0,"NORMAL":1}}]})");
    file.add("nodes", R"({"name":"glass","mesh":0,"extras":{"castsShadow":false}})");
    file.add("nodes", R"({"name":"wall","mesh":0,"extras":{"castsShadow":true,"other":"text"}})");
    file.add("nodes", R"({"name":"plain","mesh":0,"extras":"castsShadow"})");
    const candela::ImportedScene imported = load(file);
    int shadowless = 0;
    for (const candela::Node& node : imported.scene.nodes) {
        EXPECT_EQ(node.castsShadow, node.name != "glass") << node.name;
        shadowless += node.castsShadow ? 0 : 1;
    }
    EXPECT_EQ(shadowless, 2) << "all parts of its mesh";
}

TEST(Node, aSubdivisionCageTakesTheExtrasOfItsNode) {
    GltfFile file;
    addTriangle(file);
    file.add("meshes",
             R"({"primitives":[{"attributes":{"POSITION":0}}],"extras":{"candela_subdivision":{}}})");
    file.add("nodes", R"({"mesh":0,"extras":{"castsShadow":false}})");
    const candela::Scene scene = load(file).scene;
    ASSERT_TRUE(scene.nodes.at(0).cage.has_value());
    EXPECT_FALSE(scene.nodes[0].castsShadow);
}

TEST(Node, whatIsHiddenIsHiddenWithItsChildren) {
    GltfFile file = triangleFile();
    file.set("extensionsRequired", R"(["KHR_node_visibility"])");
    file.set("extensions", R"({"KHR_lights_punctual":{"lights":[{"type":"point"}]}})");
    file.add("nodes",
             R"({"name":"layer","children":[2,3],"extensions":{"KHR_node_visibility":{"visible":false}}})");
    file.add("nodes", R"({"mesh":0,"extensions":{"KHR_node_visibility":{"visible":true}}})");
    file.add("nodes", R"({"extensions":{"KHR_lights_punctual":{"light":0}}})");
    file.add("nodes", R"({"mesh":0,"extensions":{"KHR_node_visibility":{}}})");
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.report.notes.empty());
    EXPECT_EQ(candela::triangleCount(imported.scene), 2u);
    EXPECT_TRUE(imported.scene.lights.empty());
    EXPECT_EQ(imported.scene.nodes.size(), 5u);
}

}  // namespace
}  // namespace candela_test
