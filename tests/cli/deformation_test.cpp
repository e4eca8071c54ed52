// Skins and morph targets from a glTF file to the picture.

#include "../plugins/gltf/gltf_file.h"
#include "command.h"
#include "picture_reader.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using candela_test::GltfFile;

/// A quad of 100 units that one joint brings to 1 m by its bind matrix, at a node with the scale 0.01, as
/// exporters write it. A morph target moves it along its own z by 50 units.
std::string quadFile(const std::string& joint, const std::string& weight) {
    GltfFile file;
    file.addData<float>("VEC3", {-50, -50, 0, 50, -50, 0, 50, 50, 0, -50, 50, 0});
    file.addData<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    file.addData<std::uint8_t>("VEC4", std::vector<std::uint8_t>(16, 0));
    file.addData<float>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    file.addData<float>("VEC3", {0, 0, 50, 0, 0, 50, 0, 0, 50, 0, 0, 50});
    file.addData<float>("MAT4", {0.01f, 0, 0, 0, 0, 0.01f, 0, 0, 0, 0, 0.01f, 0, 0, 0, 0, 1});
    file.add("meshes", R"({"primitives":[{"mode":6,"attributes":{"POSITION":0,"NORMAL":1,"JOINTS_0":2,
                           "WEIGHTS_0":3},"targets":[{"POSITION":4}]}],"weights":[)" +
                           weight + "]}");
    file.add("nodes", R"({"mesh":0,"skin":0,"scale":[0.01,0.01,0.01],"translation":[7,7,7]})");
    file.add("nodes", "{" + joint + "}");
    file.add("skins", R"({"joints":[1],"inverseBindMatrices":5})");
    return file.text();
}

struct Range {
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
};

class Deformation : public testing::Test {
  protected:
    ExrPicture aovs(const std::string& file, const std::string& eye) const {
        folder.write("quad.gltf", file);
        expectSuccess(runCommand({"quad.gltf", "-o", "o.exr", "--aov", "all", "--size", "64x64", "--eye", eye,
                                  "--target", "0,0,0", "--fov", "45", "--samples", "1", "--quiet"},
                                 {.folder = folder.path()}));
        return readExr(folder / "o.exr");
    }

    TemporaryFolder folder;
};

/// The values of a channel where the picture shows something.
Range rangeOf(const ExrPicture& picture, const std::string& channel) {
    Range range;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            if (picture.at("A", x, y) == 0.0f) continue;
            range.low = std::min(range.low, picture.at(channel, x, y));
            range.high = std::max(range.high, picture.at(channel, x, y));
        }
    }
    return range;
}

/// A pixel is 3 m × 2 tan(22.5°) / 64 = 0.039 m wide.
constexpr float pixel = 0.04f;

void expectFrom(const ExrPicture& picture, const std::string& channel, float low, float high) {
    const Range range = rangeOf(picture, channel);
    EXPECT_NEAR(range.low, low, pixel) << channel;
    EXPECT_NEAR(range.high, high, pixel) << channel;
}

TEST_F(Deformation, SkinnedMeshIsPlacedByItsJoints) {
    const ExrPicture picture = aovs(quadFile(R"("name":"joint")", "0"), "0,0,3");
    expectFrom(picture, "P.X", -0.5f, 0.5f);
    expectFrom(picture, "P.Y", -0.5f, 0.5f);
    expectFrom(picture, "N.Z", 1.0f, 1.0f);
}

TEST_F(Deformation, MorphTargetsMoveBeforeTheSkin) {
    const ExrPicture picture = aovs(quadFile(R"("scale":[1,0.5,1])", "1"), "0,0,3");
    expectFrom(picture, "P.X", -0.5f, 0.5f);
    expectFrom(picture, "P.Y", -0.25f, 0.25f);
    expectFrom(picture, "P.Z", 0.5f, 0.5f);
}

TEST_F(Deformation, MirroredSkinShowsItsFront) {
    const std::string file = quadFile(R"("scale":[-1,1,1])", "0");
    const ExrPicture front = aovs(file, "0,0,3");
    expectFrom(front, "P.X", -0.5f, 0.5f);
    expectFrom(front, "N.Z", 1.0f, 1.0f);
    const ExrPicture back = aovs(file, "0,0,-3");
    EXPECT_GT(rangeOf(back, "P.X").low, rangeOf(back, "P.X").high) << "back faces are culled";
}

}  // namespace
