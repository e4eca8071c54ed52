// KHR_animation_pointer: that every pointer reaches its member.
#include <gtest/gtest.h>

#include <candela/scene.h>
#include <nlohmann/json.hpp>

#include "cage_file.h"
#include "loading.h"
#include "pointer_file.h"

namespace candela_test {
namespace {

using Json = nlohmann::json;

void expectSame(const candela::Material& a, const candela::Material& b) {
    EXPECT_EQ(a.baseColor, b.baseColor);
    EXPECT_EQ(a.metallic, b.metallic);
    EXPECT_EQ(a.roughness, b.roughness);
    EXPECT_EQ(a.emission, b.emission);
    EXPECT_EQ(a.emissionStrength, b.emissionStrength);
    EXPECT_EQ(a.normalScale, b.normalScale);
    EXPECT_EQ(a.occlusionStrength, b.occlusionStrength);
    EXPECT_EQ(a.alphaCutoff, b.alphaCutoff);
    EXPECT_EQ(a.ior, b.ior);
    EXPECT_EQ(a.baseColorTexture, b.baseColorTexture);
    EXPECT_EQ(a.metallicRoughnessTexture, b.metallicRoughnessTexture);
    EXPECT_EQ(a.normalTexture, b.normalTexture);
    EXPECT_EQ(a.emissionTexture, b.emissionTexture);
    EXPECT_EQ(a.occlusionTexture, b.occlusionTexture);
    EXPECT_EQ(a.specular, b.specular);
    EXPECT_EQ(a.clearcoat, b.clearcoat);
    EXPECT_EQ(a.sheen, b.sheen);
    EXPECT_EQ(a.anisotropy, b.anisotropy);
    EXPECT_EQ(a.iridescence, b.iridescence);
    EXPECT_EQ(a.transmission, b.transmission);
    EXPECT_EQ(a.volume, b.volume);
    EXPECT_EQ(a.diffuseTransmission, b.diffuseTransmission);
}

void expectSame(const candela::Scene& a, const candela::Scene& b) {
    expectSame(a.materials.at(0), b.materials.at(0));
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(a.lights.at(i).color, b.lights.at(i).color);
        EXPECT_EQ(a.lights[i].intensity, b.lights[i].intensity);
        EXPECT_EQ(a.lights[i].range, b.lights[i].range);
        EXPECT_EQ(a.lights[i].innerConeAngle, b.lights[i].innerConeAngle);
        EXPECT_EQ(a.lights[i].outerConeAngle, b.lights[i].outerConeAngle);
        EXPECT_EQ(a.cameras.at(i).verticalFov, b.cameras.at(i).verticalFov);
        EXPECT_EQ(a.cameras[i].orthographicHeight, b.cameras[i].orthographicHeight);
        EXPECT_EQ(a.cameras[i].nearPlane, b.cameras[i].nearPlane);
        EXPECT_EQ(a.cameras[i].farPlane, b.cameras[i].farPlane);
    }
}

TEST(AnimationPointer, everyPropertyIsThatOfAFileWithTheValue) {
    const candela::Scene rest = load(fileOfEverything()).scene;
    for (const Pointed& pointed : everyProperty()) {
        SCOPED_TRACE(pointed.pointer);
        GltfFile file = fileOfEverything();
        animate(file, pointed);
        candela::ImportedScene imported = load(file);
        ASSERT_TRUE(imported.report.notes.empty()) << imported.report.notes.front().line();
        ASSERT_EQ(imported.scene.animations.size(), 1u);
        EXPECT_EQ(imported.scene.animations[0].properties.size(), 1u);
        expectSame(imported.scene, rest);
        poseProperties(imported.scene, 0.0);

        Json fixed = Json::parse(fileOfEverything().text());
        Json& member = fixed[Json::json_pointer(pointed.pointer)];
        member = pointed.value.size() == 1 ? Json(pointed.value[0]) : Json(pointed.value);
        expectSame(imported.scene, loadText(fixed.dump()).scene);
    }
}

TEST(AnimationPointer, allAtOnce) {
    GltfFile file = fileOfEverything();
    Json fixed = Json::parse(file.text());
    for (const Pointed& pointed : everyProperty()) {
        animate(file, pointed);
        fixed[Json::json_pointer(pointed.pointer)] =
            pointed.value.size() == 1 ? Json(pointed.value[0]) : Json(pointed.value);
    }
    candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.report.notes.empty());
    poseProperties(imported.scene, 0.0);
    expectSame(imported.scene, loadText(fixed.dump()).scene);
}

candela::PropertyChannel propertyOf(const GltfFile& file) {
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.report.notes.empty());
    return imported.scene.animations.at(0).properties.at(0);
}

template <typename T>
std::vector<float> roughnessesAs(const std::vector<T>& values, const std::string& more = "") {
    GltfFile file = fileOfEverything();
    const int times = file.addData<float>("SCALAR", {0, 1});
    animate(file, "/materials/0/pbrMetallicRoughness/roughnessFactor", times,
            file.addData<T>("SCALAR", values, more));
    return propertyOf(file).values;
}

TEST(AnimationPointer, numbersOfEveryType) {
    const std::string normalized = R"("normalized":true)";
    const std::vector<float> expected{0, 1};
    EXPECT_EQ(roughnessesAs<float>({0, 1}), expected);
    EXPECT_EQ(roughnessesAs<std::int8_t>({0, 127}, normalized), expected);
    EXPECT_EQ(roughnessesAs<std::uint8_t>({0, 255}, normalized), expected);
    EXPECT_EQ(roughnessesAs<std::int16_t>({0, 32767}, normalized), expected);
    EXPECT_EQ(roughnessesAs<std::uint16_t>({0, 65535}, normalized), expected);
    // Those that are not normalised are the numbers themselves.
    EXPECT_EQ(roughnessesAs<std::int8_t>({0, 1}), expected);
    EXPECT_EQ(roughnessesAs<std::uint8_t>({0, 1}), expected);
    EXPECT_EQ(roughnessesAs<std::int16_t>({0, 1}), expected);
    EXPECT_EQ(roughnessesAs<std::uint16_t>({0, 1}), expected);
    EXPECT_EQ(roughnessesAs<std::uint32_t>({0, 1}), expected);
}

TEST(AnimationPointer, splinesAndSteps) {
    GltfFile file = fileOfEverything();
    const int times = file.addData<float>("SCALAR", {0, 1});
    // Tangents may have any size.
    const std::vector<float> values{-9, 0.25f, 9, -9, 0.5f, 9};
    animate(file, "/materials/0/pbrMetallicRoughness/metallicFactor", times,
            file.addData<float>("SCALAR", values), "CUBICSPLINE");
    const candela::PropertyChannel channel = propertyOf(file);
    EXPECT_EQ(channel.interpolation, candela::Interpolation::cubicSpline);
    EXPECT_EQ(channel.values, values);
}

/// A file with an animation of node 0 by pointer, and the same by path.
std::pair<candela::AnimationChannel, candela::AnimationChannel> byPointerAndPath(const std::string& path,
                                                                                 std::vector<float> values,
                                                                                 std::size_t components) {
    GltfFile file = fileOfEverything();
    const int times = file.addData<float>("SCALAR", {0, 1});
    const int output = file.addData<float>(typeOf(components), values);
    animate(file, "/nodes/0/" + path, times, output);
    file.add("animations",
             R"({"samplers":[{"input":)" + std::to_string(times) + R"(,"output":)" + std::to_string(output) +
                 R"(}],"channels":[{"sampler":0,"target":{"node":0,"path":")" + path + R"("}}]})");
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.report.notes.empty());
    return {imported.scene.animations.at(0).channels.at(0), imported.scene.animations.at(1).channels.at(0)};
}

TEST(AnimationPointer, nodesAreAnimatedAsByPath) {
    const std::vector<std::pair<std::string, std::size_t>> paths{
        {"translation", 3}, {"rotation", 4}, {"scale", 3}, {"weights", 1}};
    for (const auto& [path, components] : paths) {
        const std::vector<float> values = path == "rotation"  ? std::vector<float>{0, 0, 0, 1, 1, 0, 0, 0}
                                          : path == "weights" ? std::vector<float>{0, 1, 1, 0}
                                                              : std::vector<float>{0, 1, 2, 3, 4, 5};
        const auto [pointer, ordinary] = byPointerAndPath(path, values, components);
        EXPECT_EQ(pointer.node, ordinary.node);
        EXPECT_EQ(pointer.path, ordinary.path);
        EXPECT_EQ(pointer.times, ordinary.times);
        EXPECT_EQ(pointer.values, ordinary.values);
    }
}

TEST(AnimationPointer, weightsOfAMeshAreThoseOfNodesWithoutWeights) {
    GltfFile file = fileOfEverything();
    const int times = file.addData<float>("SCALAR", {0});
    animate(file, "/meshes/0/weights", times, file.addData<float>("SCALAR", {3, 4}));
    animate(file, "/meshes/0/weights/1", times, file.addData<float>("SCALAR", {5}));
    animate(file, "/nodes/3/weights/0", times, file.addData<float>("SCALAR", {6}));
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.report.notes.empty());
    const auto& animations = imported.scene.animations;
    ASSERT_EQ(animations.size(), 3u);
    for (std::size_t i = 0; i < 2; ++i) {
        ASSERT_EQ(animations[i].channels.size(), 1u);
        EXPECT_EQ(animations[i].channels[0].node, 0u) << "node 3 has weights of its own";
    }
    EXPECT_EQ(animations[0].channels[0].values, (std::vector<float>{3, 4}));
    EXPECT_FALSE(animations[0].channels[0].morphTarget);
    EXPECT_EQ(animations[1].channels[0].morphTarget, 1u);
    EXPECT_EQ(animations[2].channels.at(0).node, 3u);
    EXPECT_EQ(animations[2].channels[0].morphTarget, 0u);
    EXPECT_EQ(animations[2].channels[0].values, std::vector<float>{6});
}

TEST(AnimationPointer, lightsAndCamerasOfSeveralNodes) {
    GltfFile file = fileOfEverything();
    file.add("nodes", R"({"camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}})");
    animate(file, {"/extensions/KHR_lights_punctual/lights/0/intensity", {8}});
    animate(file, {"/cameras/0/perspective/yfov", {0.5f}});
    candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.report.notes.empty());
    poseProperties(imported.scene, 0.0);
    ASSERT_EQ(imported.scene.lights.size(), 3u);
    EXPECT_EQ(imported.scene.lights[0].intensity, 8.0f);
    EXPECT_EQ(imported.scene.lights[1].intensity, 1.0f);
    EXPECT_EQ(imported.scene.lights[2].intensity, 8.0f);
    EXPECT_EQ(imported.scene.cameras.at(0).verticalFov, 0.5f);
    EXPECT_EQ(imported.scene.cameras.at(2).verticalFov, 0.5f);
}

TEST(AnimationPointer, visibility) {
    GltfFile file = triangleFile();
    file.set("extensions", R"({"KHR_lights_punctual":{"lights":[{"type":"point"}]}})");
    file.add("nodes", R"({"children":[2],"extensions":{"KHR_node_visibility":{"visible":false}}})");
    file.add("nodes", R"({"mesh":0,"children":[3],"extensions":{"KHR_lights_punctual":{"light":0}}})");
    file.add("nodes", R"({"mesh":0,"extensions":{"KHR_node_visibility":{"visible":false}}})");
    const int times = file.addData<float>("SCALAR", {0, 1});
    const int flags = file.addData<std::uint8_t>("SCALAR", {0, 7});
    animate(file, "/nodes/1/extensions/KHR_node_visibility/visible", times, flags, "STEP");
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.report.notes.empty());
    const candela::PropertyChannel& channel = imported.scene.animations.at(0).properties.at(0);
    EXPECT_EQ(channel.property, candela::AnimatedProperty::visibility);
    EXPECT_EQ(channel.element, 1u);
    EXPECT_EQ(channel.values, (std::vector<float>{0, 7}));
    // What an animation may show is there, and what stays hidden is not.
    const auto& nodes = imported.scene.nodes;
    EXPECT_FALSE(nodes.at(1).visible);
    EXPECT_TRUE(nodes.at(2).visible);
    EXPECT_TRUE(nodes[2].mesh.has_value());
    EXPECT_EQ(imported.scene.lights.size(), 1u);
    EXPECT_FALSE(nodes.at(3).mesh.has_value());
}

TEST(AnimationPointer, aCopyOfAMaterialForCagesIsAnimatedToo) {
    GltfFile file = cubeFile();
    file.add("materials", "{}");
    Json text = Json::parse(file.text());
    text["images"] = Json::parse(fileOfEverything().text())["images"];
    text["textures"] = {{{"source", 0}}};
    const int uvs = static_cast<int>(text["accessors"].size());
    text["accessors"].push_back(
        {{"componentType", 5126}, {"count", text["accessors"][0]["count"]}, {"type", "VEC2"}});
    auto& primitive = text["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_1"] = uvs;
    primitive["material"] = 0;
    text["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}}}};
    text["accessors"].push_back({{"componentType", 5126}, {"count", 1}, {"type", "SCALAR"}});
    text["animations"] = {
        {{"samplers", {{{"input", uvs + 1}, {"output", uvs + 1}}}},
         {"channels", {Json::parse(channelTo("/materials/0/pbrMetallicRoughness/metallicFactor", 0))}}}};
    const candela::ImportedScene imported = loadText(text.dump());
    ASSERT_EQ(imported.scene.materials.size(), 2u);
    const auto& properties = imported.scene.animations.at(0).properties;
    ASSERT_EQ(properties.size(), 2u);
    EXPECT_EQ(properties[0].element, 0u);
    EXPECT_EQ(properties[1].element, 1u);
}

}  // namespace
}  // namespace candela_test
