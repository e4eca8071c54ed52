#include <gtest/gtest.h>

#include "cage_file.h"

namespace candela_test {
namespace {

/// A JSON attribute: `,"NAME":accessor`.
std::string attribute(const std::string& name, int accessor) {
    return ",\"" + name + "\":" + std::to_string(accessor);
}

/// Node 0 instances a square from (0, 0) to (1, 1); its lower edge follows joint 0 and its upper one joint 1,
/// both with weight 1. The joints are nodes 1 and 2.
template <typename Joint, typename Weight>
GltfFile skinnedFile(Weight one, const std::string& encoding = "") {
    GltfFile file;
    addSquareCage(file, {attribute("JOINTS_0", 2) + attribute("WEIGHTS_0", 3), "", ""});
    file.addData<Joint>("VEC4", {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    file.addData<Weight>("VEC4", {one, 0, 0, 0, one, 0, 0, 0, one, 0, 0, 0, one, 0, 0, 0}, encoding);
    return file;
}

/// Such a square, also instanced by a node with a skin of these two joints.
GltfFile poseFile() {
    GltfFile file = skinnedFile<std::uint8_t, float>(1.0f);
    file.addData<float>("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,  //
                                 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
    // Joint 1 is at (0, 1, 0) in the bind pose. Here it is at (0, 3, 0), rotated by 90 degrees about +Z.
    file.add("nodes", R"({"name":"lower","translation":[10,0,0]})");
    file.add("nodes", R"({"name":"upper","translation":[0,3,0],"rotation":[0,0,0.70710678,0.70710678]})");
    file.add("nodes", R"({"name":"body","mesh":0,"skin":0,"translation":[100,100,100]})");
    file.add("skins", R"({"name":"arm","joints":[1,2],"inverseBindMatrices":4})");
    return file;
}

void expectNear(glm::vec3 found, glm::vec3 expected) {
    // The quaternion of the file has eight digits; numbers are around 10.
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-5f) << "component " << i;
}

candela::PosedPoints poseOf(const candela::Scene& scene, std::uint32_t node, double time = 0.0) {
    return candela::poseCage(scene, node, candela::worldTransforms(scene, time), time);
}

TEST(CageMotion, aSkinDeformsTheCage) {
    const candela::Scene scene = load(poseFile()).scene;
    ASSERT_EQ(scene.skins.size(), 1u);
    EXPECT_EQ(scene.skins[0].name, "arm");
    EXPECT_EQ(scene.skins[0].joints, (std::vector<std::uint32_t>{1, 2}));
    ASSERT_EQ(scene.nodes.at(3).skin, 0u);
    const candela::PosedPoints posed = poseOf(scene, 3);
    EXPECT_EQ(posed.worldFromPoints, glm::mat4(1.0f))
        << "the node's transform does not apply to a skinned cage";
    const candela::Cage& cage = scene.cages.at(0);
    // The lower edge moves with joint 0; the bind matrix moves the upper one to y = 0, where it rotates.
    expectNear(posed.points[vertexAt(cage, {0, 0, 0})], {10, 0, 0});
    expectNear(posed.points[vertexAt(cage, {1, 0, 0})], {11, 0, 0});
    expectNear(posed.points[vertexAt(cage, {0, 1, 0})], {0, 3, 0});
    expectNear(posed.points[vertexAt(cage, {1, 1, 0})], {0, 4, 0});
}

TEST(CageMotion, aNodeWithoutTheSkinHasTheBindPose) {
    const candela::Scene scene = load(poseFile()).scene;
    EXPECT_FALSE(scene.nodes.at(0).skin.has_value());
    EXPECT_EQ(poseOf(scene, 0).points, scene.cages.at(0).positions);
}

TEST(CageMotion, nodesMayHaveDifferentSkins) {
    GltfFile file = poseFile();
    file.add("nodes", R"({"mesh":0,"skin":1})");
    file.add("skins", R"({"joints":[2,1]})");
    const candela::Scene scene = load(file).scene;
    ASSERT_EQ(scene.skins.size(), 2u);
    EXPECT_EQ(scene.cages.size(), 1u);
    const candela::PosedPoints posed = poseOf(scene, 4);
    // No bind matrices: identities.
    expectNear(posed.points[vertexAt(scene.cages[0], {1, 1, 0})], {11, 1, 0});
}

TEST(CageMotion, influencesOfEveryEncoding) {
    const auto check = [](const GltfFile& file) {
        const candela::Cage cage = cageOf(file);
        ASSERT_EQ(cage.influenceCount, 4u);
        const std::uint32_t upper = vertexAt(cage, {0, 1, 0});
        EXPECT_EQ(cage.joints.at(4 * upper), 1u);
        EXPECT_EQ(cage.jointWeights.at(4 * upper), 1.0f);
        EXPECT_EQ(cage.jointWeights.at(4 * upper + 1), 0.0f);
    };
    check(skinnedFile<std::uint8_t, float>(1.0f));
    check(skinnedFile<std::uint16_t, std::uint8_t>(255, R"("normalized":true)"));
    check(skinnedFile<std::uint8_t, std::uint16_t>(65535, R"("normalized":true)"));
}

TEST(CageMotion, furtherSetsOfJoints) {
    GltfFile file;
    addSquareCage(file, {attribute("JOINTS_0", 2) + attribute("WEIGHTS_0", 3) + attribute("JOINTS_1", 4) +
                             attribute("WEIGHTS_1", 3),
                         "", ""});
    file.addData<std::uint8_t>("VEC4", std::vector<std::uint8_t>(16, 1));
    file.addData<float>("VEC4", {0.5f, 0, 0, 0, 0.5f, 0, 0, 0, 0.5f, 0, 0, 0, 0.5f, 0, 0, 0});
    file.addData<std::uint16_t>("VEC4", std::vector<std::uint16_t>(16, 700));
    const candela::Cage cage = cageOf(file);
    EXPECT_EQ(cage.influenceCount, 8u);
    EXPECT_EQ(std::vector(cage.joints.begin(), cage.joints.begin() + 8),
              (std::vector<std::uint32_t>{1, 0, 0, 0, 700, 0, 0, 0}))
        << "joints without weight are set to 0";
    EXPECT_EQ(cage.jointWeights.at(4), 0.5f);
}

TEST(CageMotion, verticesWithDifferentInfluencesAreNotWelded) {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0});
    file.addData<std::uint8_t>("VEC4", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  //
                                        1, 0, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0});
    file.addData<float>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    addCageMesh(file, R"({"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}})", "{}");
    // The vertices at (0, 1, 0) have different joints; those at (1, 0, 0) differ in a joint of weight 0 only.
    EXPECT_EQ(cageOf(file).positions.size(), 5u);
}

TEST(CageMotion, skinnedCagesGiveNoBindPoseNote) {
    EXPECT_TRUE(load(poseFile()).report.notes.empty());
}

/// A square with two morph targets: one moves vertex 2, at (1, 1, 0), by (0, 0, 4), the other all of them by
/// (1, 0, 0). The first is a sparse accessor without a bufferView.
GltfFile morphedFile(const std::string& mesh = "", const std::string& targets = "") {
    GltfFile file;
    addSquareCage(
        file,
        {"", targets.empty() ? R"(,"targets":[{"POSITION":2},{"NORMAL":0,"POSITION":3}])" : targets, mesh});
    const std::string index = std::to_string(file.addView({2}));
    const std::string value = std::to_string(file.addView(bytesOf<float>({0, 0, 4})));
    file.addAccessor(-1, "VEC3", 5126, 4,
                     R"("sparse":{"count":1,"indices":{"bufferView":)" + index +
                         R"(,"componentType":5121},"values":{"bufferView":)" + value + "}}");
    file.addData<float>("VEC3", {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0});
    return file;
}

TEST(CageMotion, morphTargets) {
    const candela::ImportedScene imported = load(morphedFile());
    EXPECT_TRUE(imported.report.notes.empty());
    const candela::Cage& cage = imported.scene.cages.at(0);
    ASSERT_EQ(cage.morphTargets.size(), 2u);
    EXPECT_EQ(cage.morphTargets[0].offsets[vertexAt(cage, {1, 1, 0})], glm::vec3(0, 0, 4));
    EXPECT_EQ(cage.morphTargets[0].offsets[vertexAt(cage, {0, 1, 0})], glm::vec3(0));
    EXPECT_EQ(cage.morphTargets[1].offsets, std::vector<glm::vec3>(4, glm::vec3(1, 0, 0)));
}

TEST(CageMotion, aTargetWithoutPositionsHasNoEffect) {
    const candela::Cage cage = cageOf(morphedFile("", R"(,"targets":[{"NORMAL":0}])"));
    ASSERT_EQ(cage.morphTargets.size(), 1u);
    EXPECT_EQ(cage.morphTargets[0].offsets, std::vector<glm::vec3>(4, glm::vec3(0)));
}

TEST(CageMotion, verticesWithDifferentMorphOffsetsAreNotWelded) {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0});
    file.addData<float>("VEC3", {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, 0, 0});
    addCageMesh(file, R"({"attributes":{"POSITION":0},"targets":[{"POSITION":1}]})", "{}");
    EXPECT_EQ(cageOf(file).positions.size(), 5u);
}

glm::vec3 posedCorner(const candela::Scene& scene, std::uint32_t node, double time = 0.0) {
    return poseOf(scene, node, time).points[vertexAt(scene.cages.at(0), {1, 1, 0})];
}

TEST(CageMotion, nodeWeightsOverrideMeshWeights) {
    GltfFile file = morphedFile(R"("weights":[0.5,2])");
    file.add("nodes", R"({"mesh":0,"weights":[0.25,0]})");
    const candela::Scene scene = load(file).scene;
    EXPECT_EQ(scene.nodes.at(0).morphWeights, (std::vector<float>{0.5f, 2.0f}));
    EXPECT_EQ(scene.nodes.at(1).morphWeights, (std::vector<float>{0.25f, 0.0f}));
    // Exact in single precision.
    EXPECT_EQ(posedCorner(scene, 0), glm::vec3(3, 1, 2));
    EXPECT_EQ(posedCorner(scene, 1), glm::vec3(1, 1, 1));
}

TEST(CageMotion, weightsAreZeroByDefault) {
    EXPECT_EQ(posedCorner(load(morphedFile()).scene, 0), glm::vec3(1, 1, 0));
}

/// The first target's weight goes from 0 to 1 in two seconds, the second one's from 1 to 0.
GltfFile animatedFile(const std::string& interpolation = "LINEAR", std::vector<float> values = {0, 1, 1, 0},
                      const std::string& node = "0") {
    GltfFile file = morphedFile();
    const std::string times = std::to_string(file.addData<float>("SCALAR", {0, 2}));
    const std::string output = std::to_string(file.addData<float>("SCALAR", values));
    file.add("nodes", "{}");
    file.add("animations", R"({"name":"wave","samplers":[{"input":)" + times + R"(,"output":)" + output +
                               R"(,"interpolation":")" + interpolation +
                               R"("}],"channels":[{"sampler":0,"target":{"node":)" + node +
                               R"(,"path":"weights"}}]})");
    return file;
}

TEST(CageMotion, animatedWeights) {
    const candela::ImportedScene imported = load(animatedFile());
    EXPECT_TRUE(imported.report.notes.empty());
    const candela::AnimationChannel& channel = imported.scene.animations.at(0).channels.at(0);
    EXPECT_EQ(channel.path, candela::AnimationPath::morphWeights);
    EXPECT_EQ(channel.node, 0u);
    EXPECT_EQ(channel.times, (std::vector<float>{0, 2}));
    EXPECT_EQ(channel.values, (std::vector<float>{0, 1, 1, 0}));
    // At 0.5 s the weights are 0.25 and 0.75. Exact in single precision.
    EXPECT_EQ(posedCorner(imported.scene, 0, 0.5), glm::vec3(1.75f, 1, 1));
}

TEST(CageMotion, animatedWeightsMayBeSplines) {
    std::vector<float> values(12);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
    const candela::Scene scene = load(animatedFile("CUBICSPLINE", values)).scene;
    EXPECT_EQ(scene.animations.at(0).channels.at(0).values, values);
}

TEST(CageMotion, weightsOfANodeWithAMatrixMayBeAnimated) {
    GltfFile file = morphedFile();
    file.add("nodes", R"({"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,5,0,0,1]})");
    const std::string times = std::to_string(file.addData<float>("SCALAR", {0}));
    const std::string output =
        std::to_string(file.addData<std::uint8_t>("SCALAR", {255, 0}, R"("normalized":true)"));
    file.add("animations", R"({"samplers":[{"input":)" + times + R"(,"output":)" + output +
                               R"(}],"channels":[{"sampler":0,"target":{"node":1,"path":"weights"}}]})");
    EXPECT_EQ(posedCorner(load(file).scene, 1), glm::vec3(1, 1, 4));
}

TEST(CageMotion, weightsOfOtherNodesAreNoted) {
    EXPECT_TRUE(hasNote(load(animatedFile("LINEAR", {0, 1, 1, 0}, "1")),
                        "animation 0 'wave', channel 0: node 1 has no mesh with morph targets"));
}

TEST(CageMotion, animatedWeightsMustMatchTheTargets) {
    const std::string error = complaintsOf(animatedFile("LINEAR", {0, 1}));
    EXPECT_NE(error.find("animation 0 'wave', channel 0, output: accessor"), std::string::npos) << error;
    EXPECT_NE(error.find("has 2 elements, expected 4"), std::string::npos) << error;
}

}  // namespace
}  // namespace candela_test
