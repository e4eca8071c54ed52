// Where pictures go and what their files say: standard output, several cameras, turntables, EXR metadata.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfRationalAttribute.h>
#include <ImfStandardAttributes.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <numbers>

namespace {

using Names = std::vector<std::string>;

class Output : public testing::Test {
  protected:
    Output() { folder.write("square.gltf", sampleScene()); }

    /// 16 × 8 pixels.
    CommandResult render(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"square.gltf", "--size", "16x8", "--samples", "1"});
        return runCommand(arguments, {.folder = folder.path()});
    }
    std::string bytes(const std::string& name) const {
        std::ifstream stream(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    TemporaryFolder folder;
};

TEST_F(Output, StandardOutputIsTheFile) {
    expectSuccess(render({"-o", "a#.png", "--frames", "0-5"}));
    const CommandResult result = render({"-o", "-", "--frames", "0-5", "--encode-threads", "4"});
    expectSuccess(result);
    std::string all;
    for (int i = 0; i < 6; ++i) all += bytes("a" + std::to_string(i) + ".png");
    EXPECT_EQ(result.out, all);
    EXPECT_NE(result.err.find("wrote 6 pictures to standard output: "), std::string::npos) << result.err;

    expectSuccess(render({"-o", "a.exr"}));
    EXPECT_EQ(render({"-o", "-", "--format", "exr", "--quiet"}).out, bytes("a.exr"));
}

TEST_F(Output, RawBytesAreThePixels) {
    expectSuccess(render({"-o", "a#.png", "--frames", "0-1"}));
    const CommandResult result = render({"-o", "-", "--raw", "rgba8", "--frames", "0-1", "--quiet"});
    expectSuccess(result);
    std::vector<std::uint8_t> pixels = readPng(folder / "a0.png").rgba;
    const std::vector<std::uint8_t> second = readPng(folder / "a1.png").rgba;
    pixels.insert(pixels.end(), second.begin(), second.end());
    EXPECT_EQ(std::vector<std::uint8_t>(result.out.begin(), result.out.end()), pixels);
    expectSuccess(render({"-o", "a.rgba", "--raw", "rgba8"}));
    EXPECT_EQ(bytes("a.rgba"), result.out.substr(0, result.out.size() / 2));
}

TEST_F(Output, PngLevelsKeepThePixels) {
    expectSuccess(render({"-o", "0.png", "--png-level", "0"}));
    expectSuccess(render({"-o", "9.png", "--png-level", "9"}));
    EXPECT_EQ(readPng(folder / "0.png").rgba, readPng(folder / "9.png").rgba);
    EXPECT_GT(bytes("0.png").size(), bytes("9.png").size());
}

TEST_F(Output, EveryCameraHasItsPicture) {
    expectSuccess(render({"-o", "a.png", "--camera", "all"}));
    expectSuccess(render({"-o", "{camera}-#.png", "--camera", "far,front", "--frames", "0"}));
    expectSuccess(render({"-o", "{camera}.png", "--camera", "far"}));
    EXPECT_EQ(folder.names(),
              (Names{"a.far.png", "a.front.png", "far-0.png", "far.png", "front-0.png", "square.gltf"}));
    EXPECT_EQ(bytes("a.far.png"), bytes("far.png"));
    EXPECT_EQ(bytes("a.far.png"), bytes("far-0.png"));
    EXPECT_EQ(bytes("a.front.png"), bytes("front-0.png"));
    EXPECT_NE(bytes("a.front.png"), bytes("a.far.png"));
    expectFault(render({"-o", "b.png", "--camera", "far,near", "--quiet"}), "square.gltf",
                "no camera \"near\"");
}

template <typename Attribute>
auto attribute(const std::string& path, const char* name) {
    return Imf::InputFile(path.c_str()).header().typedAttribute<Attribute>(name).value();
}

/// A point of the world in the space that a matrix of the header leads to, as OpenEXR's readers take it.
Imath::V3f mapped(const std::string& path, const char* matrix, const Imath::V3f& point) {
    return point * attribute<Imf::M44fAttribute>(path, matrix);
}

/// Single precision of coordinates below 10, over a few operations.
constexpr float rounding = 1.0e-5f;

void expectNear(const Imath::V3f& got, const Imath::V3f& expected) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(got[axis], expected[axis], rounding) << got;
}

TEST_F(Output, ExrNamesTheCamera) {
    // The camera "front" is at (0, 0, 3) and looks along -Z with 90 degrees: at the square's distance the
    // picture is 6 m high and 12 m wide.
    expectSuccess(render({"-o", "a.exr", "--frames", "7", "--fps", "23.976"}));
    const std::string path = folder / "a.0007.exr";
    expectNear(mapped(path, "worldToCamera", {1, 2, -1}), {1, 2, 4});
    const auto ndc = [&](const Imath::V3f& point) {
        const Imath::V3f mappedPoint = mapped(path, "worldToNDC", point);
        return Imath::V3f(mappedPoint.x, mappedPoint.y, 0.0f);
    };
    expectNear(ndc({0, 0, 0}), {0.5f, 0.5f, 0});
    expectNear(ndc({-6, 3, 0}), {0, 0, 0});
    expectNear(ndc({6, -3, 0}), {1, 1, 0});
    EXPECT_NEAR(attribute<Imf::FloatAttribute>(path, "screenWindowWidth"), 4.0f, rounding);
    EXPECT_EQ(attribute<Imf::IntAttribute>(path, "imageCounter"), 7);
    const Imf::Rational rate = attribute<Imf::RationalAttribute>(path, "framesPerSecond");
    EXPECT_EQ(rate.n, 2997);
    EXPECT_EQ(rate.d, 125u);
    const std::map<std::string, std::string> texts = readExr(path).texts;
    EXPECT_EQ(texts.at("cameraLabel"), "front");
    EXPECT_EQ(texts.at("software"), "candela " CANDELA_VERSION);
    EXPECT_EQ(texts.at("colorInteropID"), "lin_rec709_scene");
    EXPECT_FALSE(texts.at("workingSpace").empty());
}

TEST_F(Output, APanoramaHasNoProjection) {
    expectSuccess(render({"-o", "a.exr", "--panorama"}));
    const std::string path = folder / "a.exr";
    expectNear(mapped(path, "worldToCamera", {1, 2, -1}), {1, 2, 4});
    EXPECT_FALSE(Imf::hasWorldToNDC(Imf::InputFile(path.c_str()).header()));
}

TEST_F(Output, ExrMatricesAgreeWithPositionAndDepth) {
    expectSuccess(render({"-o", "a.exr", "--aov", "P,Z", "--camera", "far"}));
    expectSuccess(render({"-o", "b.exr", "--aov", "P,Z", "--eye=1,2,4", "--target=0,0,0", "--ortho", "3"}));
    for (const char* name : {"a.exr", "b.exr"}) {
        const std::string path = folder / name;
        const ExrPicture picture = readExr(path);
        for (const auto& [x, y] : {std::pair{8, 4}, {7, 4}, {8, 3}}) {
            const Imath::V3f point(picture.at("P.X", x, y), picture.at("P.Y", x, y), picture.at("P.Z", x, y));
            const Imath::V3f ndc = mapped(path, "worldToNDC", point);
            EXPECT_NEAR(ndc.x, (static_cast<float>(x) + 0.5f) / 16.0f, rounding) << name;
            EXPECT_NEAR(ndc.y, (static_cast<float>(y) + 0.5f) / 8.0f, rounding) << name;
            EXPECT_NEAR(mapped(path, "worldToCamera", point).z, picture.at("Z", x, y), rounding) << name;
        }
    }
}

TEST_F(Output, ATurntableGoesAroundTheScene) {
    expectSuccess(render({"-o", "t#.exr", "--turntable", "4", "--encode-threads", "2"}));
    // The scene's middle is the square's, at the origin; the camera starts at (0, 0, 3) and turns
    // counter-clockwise from above.
    const Imath::V3f eyes[] = {{0, 0, 3}, {3, 0, 0}, {0, 0, -3}, {-3, 0, 0}};
    for (int i = 0; i < 4; ++i) {
        const std::string path = folder / ("t" + std::to_string(i) + ".exr");
        expectNear(mapped(path, "worldToCamera", eyes[i]), {0, 0, 0});
        expectNear(mapped(path, "worldToCamera", {0, 1, 0}), {0, 1, 3});
    }
    expectSuccess(render({"-o", "s#.exr", "--turntable", "4", "--frames", "1"}));
    EXPECT_EQ(bytes("s1.exr"), bytes("t1.exr"));
    EXPECT_EQ(folder.names().size(), 6u);
    expectUsageError(render({"--turntable", "4", "--frames", "4"}), "has none of number 4");
}

}  // namespace
