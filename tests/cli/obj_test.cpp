// OBJ files as people have them: drawn, from both sides, with notes.

#include "command.h"
#include "picture_reader.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using Arguments = std::vector<std::string>;

const std::string square = "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\n";

class ObjFiles : public testing::Test {
  protected:
    ExrPicture draw(const std::string& text, Arguments arguments) {
        folder.write("a.obj", text);
        arguments.insert(arguments.begin(), {"a.obj", "-o", "a.exr", "--aov", "all", "--size", "64x48"});
        const CommandResult result = runCommand(arguments, {.folder = folder.path()});
        expectSuccess(result);
        notes = result.err;
        return readExr(folder / "a.exr");
    }

    TemporaryFolder folder;
    std::string notes;
};

std::size_t coveredPixels(const ExrPicture& picture) {
    std::size_t count = 0;
    for (const float alpha : picture.channels.at("A")) count += alpha > 0.0f;
    return count;
}

void expectNormal(const ExrPicture& picture, float z) {
    // The octahedral encoding is exact along the axes.
    EXPECT_EQ(picture.at("N.X", 32, 24), 0.0f);
    EXPECT_EQ(picture.at("N.Y", 32, 24), 0.0f);
    EXPECT_EQ(picture.at("N.Z", 32, 24), z);
}

TEST_F(ObjFiles, ShowTheSideOfTheirNormals) {
    const Arguments fromFront{"--eye", "0,0,5", "--target", "0,0,0"};
    const ExrPicture turned = draw(square + "vn 0 0 1\nf 4//1 3//1 2//1 1//1\n", fromFront);
    expectNormal(turned, 1.0f);
    EXPECT_EQ(turned.channels, draw(square + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\n", fromFront).channels);
}

TEST_F(ObjFiles, AreDrawnAndLitFromBothSides) {
    // The default lights are at the camera.
    const auto from = [&](const char* eye) {
        return draw(square + "f 1 2 3 4\n", {"--eye", eye, "--target", "0,0,0", "--environment", "none"});
    };
    const ExrPicture front = from("0,0,5"), back = from("0,0,-5");
    expectNormal(front, 1.0f);
    expectNormal(back, -1.0f);
    EXPECT_EQ(coveredPixels(front), coveredPixels(back));
    EXPECT_GT(front.at("R", 32, 24), 0.1f);
    // The same view but for rounding of directions.
    EXPECT_NEAR(back.at("R", 32, 24), front.at("R", 32, 24), 1e-3f);
}

TEST_F(ObjFiles, AreDrawnWithoutTheirMaterialFile) {
    const std::string text = "mtllib scan.mtl\nusemtl m\n" + square + "f 1 2 3 4\nf 1 2 9\n";
    EXPECT_GT(coveredPixels(draw(text, {})), 0u);
    EXPECT_NE(notes.find("scan.mtl"), std::string::npos);
    EXPECT_NE(notes.find("left out: faces with a vertex that is not there"), std::string::npos);
    const CommandResult strict = runCommand({"a.obj", "--strict"}, {.folder = folder.path()});
    expectFault(strict, "a.obj", "left out: faces with a vertex that is not there");
}

}  // namespace
