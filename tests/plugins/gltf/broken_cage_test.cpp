#include <gtest/gtest.h>

#include <functional>

#include "cage_file.h"

namespace candela_test {
namespace {

/// A broken file, and what its error message or a note must contain.
struct BrokenCage {
    const char* name;
    std::function<void(GltfFile&)> write;
    std::vector<std::string> parts;
};

std::ostream& operator<<(std::ostream& out, const BrokenCage& broken) {
    return out << broken.name;
}

/// Joints 0 for all four vertices of a square: accessor 2; weights 1: accessor 3.
void addInfluences(GltfFile& file, float weight = 1.0f, std::uint8_t joint = 0) {
    std::vector<std::uint8_t> joints(16);
    std::vector<float> weights(16);
    for (std::size_t i = 0; i < 16; i += 4) {
        joints[i] = joint;
        weights[i] = weight;
    }
    file.addData<std::uint8_t>("VEC4", joints);
    file.addData<float>("VEC4", weights);
}

constexpr const char* influences = R"(,"JOINTS_0":2,"WEIGHTS_0":3)";

void writeSkinned(GltfFile& file, const std::string& skin, std::uint8_t joint = 0) {
    addSquareCage(file, {influences, "", ""});
    addInfluences(file, 1.0f, joint);
    file.add("nodes", R"({"name":"body","mesh":0,"skin":0})");
    file.add("skins", skin);
}

void writeMorphed(GltfFile& file, const std::string& targets, const std::string& mesh = "") {
    addSquareCage(file, {"", R"(,"targets":)" + targets, mesh});
    file.addData<float>("VEC3", std::vector<float>(12));
}

const BrokenCage brokenCages[] = {
    {"jointsWithoutWeights",
     [](GltfFile& file) {
         addSquareCage(file, {R"(,"JOINTS_0":2)", "", ""});
         addInfluences(file);
     },
     {"mesh 0 'cage', primitive 0", "has no WEIGHTS_0"}},
    {"jointsNotNumberedFromZero",
     [](GltfFile& file) {
         addSquareCage(file, {R"(,"JOINTS_1":2,"WEIGHTS_1":3)", "", ""});
         addInfluences(file);
     },
     {"mesh 0 'cage', primitive 0", "has no JOINTS_0", "numbered from 0 on"}},
    {"jointsOfFloats",
     [](GltfFile& file) {
         addSquareCage(file, {R"(,"JOINTS_0":3,"WEIGHTS_0":3)", "", ""});
         addInfluences(file);
     },
     {"mesh 0 'cage', primitive 0, attribute JOINTS_0",
      "VEC4 of FLOAT, expected VEC4 of UNSIGNED_BYTE or UNSIGNED_SHORT"}},
    {"jointsOfSomePrimitivesOnly",
     [](GltfFile& file) {
         file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
         file.addData<std::uint8_t>("SCALAR", {0, 1, 2});
         addInfluences(file);
         addCageMesh(file,
                     R"({"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},"indices":1},)"
                     R"({"attributes":{"POSITION":0},"indices":1})",
                     "{}");
     },
     {"mesh 0 'cage', primitive 1", "has no JOINTS_0, which other primitives of the mesh have"}},
    {"skinWithoutInfluences",
     [](GltfFile& file) {
         addSquareCage(file);
         file.add("nodes", R"({"name":"body","mesh":0,"skin":0})");
         file.add("skins", R"({"joints":[0]})");
     },
     {"node 1 'body'", "has skin 0, but mesh 0 'cage' has no JOINTS_0"}},
    {"jointBeyondTheSkin",
     [](GltfFile& file) { writeSkinned(file, R"({"name":"arm","joints":[0,1]})", 2); },
     {"node 1 'body'", "joint 2, but skin 0 'arm' has 2"}},
    {"skinThatDoesNotExist",
     [](GltfFile& file) {
         addSquareCage(file);
         file.add("nodes", R"({"mesh":0,"skin":0})");
     },
     {"node 1", "skin 0 does not exist"}},
    {"skinWithoutJoints",
     [](GltfFile& file) { writeSkinned(file, R"({"joints":[]})"); },
     {"skin 0", "has no joints"}},
    {"jointThatDoesNotExist",
     [](GltfFile& file) { writeSkinned(file, R"({"joints":[5]})"); },
     {"skin 0, joints", "node 5 does not exist"}},
    {"jointOutsideTheScene",
     [](GltfFile& file) {
         writeSkinned(file, R"({"joints":[0,2]})");
         file.add("nodes", R"({"name":"far"})");
         file.add("scenes", R"({"nodes":[0,1]})");
     },
     {"skin 0", "its joint 1, node 2 'far', is not in the scene"}},
    {"tooFewBindMatrices",
     [](GltfFile& file) {
         writeSkinned(file, R"({"joints":[0,1],"inverseBindMatrices":4})");
         file.addData<float>("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
     },
     {"skin 0, inverseBindMatrices", "accessor 4 has 1 elements, expected one for each of 2 joints"}},
    {"bindMatricesThatAreNotAffine",
     [](GltfFile& file) {
         writeSkinned(file, R"({"joints":[0],"inverseBindMatrices":4})");
         file.addData<float>("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.5f, 0, 0, 0, 1});
     },
     {"skin 0, inverseBindMatrices", "matrix 0 is not affine"}},
    {"bindMatricesOfAnotherType",
     [](GltfFile& file) { writeSkinned(file, R"({"joints":[0],"inverseBindMatrices":3})"); },
     {"skin 0, inverseBindMatrices", "VEC4 of FLOAT, expected MAT4 of FLOAT"}},
    {"targetOfAnotherSize",
     [](GltfFile& file) { writeMorphed(file, R"([{"POSITION":1}])"); },
     {"mesh 0 'cage', primitive 0, target 0, attribute POSITION", "6 elements, expected 4"}},
    {"targetThatDoesNotExist",
     [](GltfFile& file) { writeMorphed(file, R"([{"POSITION":2},{"POSITION":99}])"); },
     {"mesh 0 'cage', primitive 0, targets 1, attribute POSITION", "accessor 99 does not exist"}},
    {"targetsThatAreNoArray",
     [](GltfFile& file) { writeMorphed(file, R"({"POSITION":2})"); },
     {"mesh 0 'cage', primitive 0, targets", "expected an array"}},
    {"targetsOfSomePrimitivesOnly",
     [](GltfFile& file) {
         file.addData<float>("VEC3", std::vector<float>(9));
         addCageMesh(file,
                     R"({"attributes":{"POSITION":0},"targets":[{"POSITION":0}]},)"
                     R"({"attributes":{"POSITION":0}})",
                     "{}");
     },
     {"mesh 0 'cage', primitive 1", "has 0 morph targets, expected 1"}},
    {"weightsOfTheMesh",
     [](GltfFile& file) { writeMorphed(file, R"([{"POSITION":2}])", R"("weights":[1,0])"); },
     {"mesh 0 'cage'", "has 2 morph weights, expected 1"}},
    {"weightsOfTheNode",
     [](GltfFile& file) {
         writeMorphed(file, R"([{"POSITION":2}])");
         file.add("nodes", R"({"name":"body","mesh":0,"weights":[1,0,0]})");
     },
     {"node 1 'body'", "has 3 morph weights, expected 1"}},
    {"animatedWeightsWithoutTargets",
     [](GltfFile& file) {
         addSquareCage(file);
         file.addData<float>("SCALAR", {0});
         file.add("animations", R"({"samplers":[{"input":2,"output":2}],
                                    "channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}]})");
     },
     {"animation 0, channel 0", "node 0 has no mesh with morph targets"}},
};

TEST(CageInfluences, weightsThatAreNotOver0AreRepaired) {
    for (const float weight : {0.0f, -1.0f}) {
        GltfFile file;
        addSquareCage(file, {influences, "", ""});
        addInfluences(file, weight);
        const candela::ImportedScene imported = load(file);
        EXPECT_EQ(imported.scene.cages.at(0).jointWeights.at(0), 1.0f);
        EXPECT_TRUE(
            hasNote(imported, "vertices whose joint weights are all 0, moved by the skin's first joint"));
        EXPECT_EQ(hasNote(imported, "joint weights below 0, taken as 0"), weight < 0.0f);
    }
}

class BrokenCages : public testing::TestWithParam<BrokenCage> {};

TEST_P(BrokenCages, areNamed) {
    GltfFile file;
    GetParam().write(file);
    const std::string error = complaintsOf(file);
    for (const std::string& part : GetParam().parts) {
        EXPECT_NE(error.find(part), std::string::npos) << "'" << part << "' in: " << error;
    }
}

INSTANTIATE_TEST_SUITE_P(, BrokenCages, testing::ValuesIn(brokenCages),
                         [](const auto& broken) { return std::string(broken.param.name); });

}  // namespace
}  // namespace candela_test
