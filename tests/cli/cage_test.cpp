// Subdivision cages in candela-render: refinement, debug views, and errors that name the cage.

#include "command.h"
#include "picture_reader.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

namespace {

/// A cube of six quads; a plain .obj, so that it is a cage only when asked for.
constexpr const char* cube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

class Cages : public testing::Test {
  protected:
    Cages() { folder.write("cube.obj", cube); }

    PngPicture png(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--size", "64x64", "--quiet", "-o", "test.png"});
        expectSuccess(runCommand(arguments, {.folder = folder.path()}));
        return readPng(folder / "test.png");
    }

    TemporaryFolder folder;
};

std::size_t coveredPixels(const PngPicture& normals) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < normals.rgba.size(); i += 4)
        count += normals.rgba[i] + normals.rgba[i + 1] + normals.rgba[i + 2] > 0;
    return count;
}

TEST_F(Cages, AreSmallerThanTheirPolygons) {
    const std::size_t polygons = coveredPixels(png({"cube.obj", "--show", "normals"}));
    const std::size_t surface = coveredPixels(png({"cube.obj?subdivide", "--show", "normals"}));
    EXPECT_GT(surface, polygons / 3);
    EXPECT_LT(surface, polygons);
}

TEST_F(Cages, HaveFlatPolygonsAndSmoothSurfaces) {
    EXPECT_LE(png({"cube.obj", "--show", "normals"}).colors(), 4u);  // three sides and the background
    EXPECT_GT(png({"cube.obj?subdivide", "--show", "normals"}).colors(), 100u);
}

TEST_F(Cages, TakeTheLevelOfTheOption) {
    const PngPicture first = png({"cube.obj?subdivide", "--subdivision-level", "1", "--show", "level"});
    const PngPicture third = png({"cube.obj?subdivide", "--subdivision-level", "3", "--show", "level"});
    EXPECT_EQ(first.colors(), 2u);
    EXPECT_EQ(third.colors(), 2u);
    EXPECT_NE(first.rgba, third.rgba);
    const std::string longEdges = "256", shortEdges = "2";
    const auto edges = [&](const std::string& pixels) {
        return png({"cube.obj?subdivide", "--subdivision-edge", pixels, "--show", "level"}).rgba;
    };
    EXPECT_EQ(edges(longEdges), first.rgba);
    EXPECT_NE(edges(shortEdges), first.rgba);
}

TEST_F(Cages, ShowTheirLinesOverThePicture) {
    const std::vector<std::string> plain{"cube.obj?subdivide", "--scatter-lights", "9"};
    const auto with = [&](const char* lines) {
        std::vector<std::string> arguments = plain;
        arguments.insert(arguments.end(), {"--show", lines});
        return png(arguments).rgba;
    };
    const std::vector<std::uint8_t> picture = png(plain).rgba;
    EXPECT_EQ(with("picture"), picture);
    EXPECT_NE(with("wireframe"), picture);
    EXPECT_NE(with("cage"), picture);
    EXPECT_NE(with("cage"), with("wireframe"));
}

TEST_F(Cages, AreRejectedByNameWhenStrict) {
    folder.write("sharp.obj", std::string(cube) + "t crease 2/1/0 0 6 2.0\n");
    const CommandResult result = runCommand({"sharp.obj", "--strict"}, {.folder = folder.path()});
    expectFault(result, "sharp.obj", "line 15, t crease, edge 0 6: an edge of no face: not used");
}

}  // namespace
