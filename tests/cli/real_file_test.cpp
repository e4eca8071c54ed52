// glTF files as exporters write them, against or beside the specification: what is drawn, and what is said.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <png.h>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace {

using Json = nlohmann::json;

constexpr int size = 32;

/// Changes of the sample scene: a square with x and y from -1 to 1, a light 1 m and a camera 3 m before it.
class RealFile : public testing::Test {
  protected:
    RealFile() {
        scene["nodes"][0].erase("extensions");
        scene["extensionsUsed"] = {"KHR_lights_punctual"};
    }

    CommandResult run(std::vector<std::string> options = {}) const {
        folder.write("scene.gltf", scene.dump());
        options.insert(options.begin(), {"scene.gltf", "-o", "test.exr", "--aov", "all", "--size", "32x32"});
        return runCommand(options, {.folder = folder.path()});
    }
    /// Draws the scene. `note` has to be a part of what is said; where it is "", --strict has to take the
    /// scene.
    ExrPicture draw(const std::string& note) const {
        const CommandResult result =
            run(note.empty() ? std::vector<std::string>{"--strict"} : std::vector<std::string>{});
        expectSuccess(result);
        EXPECT_NE(result.err.find(note), std::string::npos) << result.err;
        return readExr(folder / "test.exr");
    }
    Json& material() { return scene["materials"][0]; }
    Json& light() { return scene["extensions"]["KHR_lights_punctual"]["lights"][0]; }

    Json scene = Json::parse(sampleScene());
    TemporaryFolder folder;
};

float center(const ExrPicture& picture, const std::string& channel) {
    return picture.at(channel, size / 2, size / 2);
}

TEST_F(RealFile, WithoutAMaterialItIsMetallicAndRough) {
    scene["meshes"][0]["primitives"][0].erase("material");
    ExrPicture without = draw("");
    // glTF's default material comes behind the one of the file.
    EXPECT_EQ(center(without, "material_id"), 2.0f);
    EXPECT_EQ(center(without, "metallic"), 1.0f);
    EXPECT_EQ(center(without, "roughness"), 1.0f);
    material() = Json::object();
    scene["meshes"][0]["primitives"][0]["material"] = 0;
    ExrPicture with = draw("");
    EXPECT_EQ(center(with, "material_id"), 1.0f);
    without.channels.erase("material_id");
    with.channels.erase("material_id");
    EXPECT_EQ(with.channels, without.channels);
}

TEST_F(RealFile, FactorsAboveOneAreHeldAtOne) {
    for (const double factor : {1.0000000000000002, 1.00016, 7.0}) {
        material()["pbrMetallicRoughness"]["baseColorFactor"] = {factor, 1, 1, 1};
        const ExrPicture picture =
            draw("material 0, pbrMetallicRoughness, baseColorFactor: more than 1, clamped");
        EXPECT_EQ(center(picture, "base_color.R"), 1.0f);
    }
}

TEST_F(RealFile, EmissionAboveOneIsHeldAtOne) {
    material()["emissiveFactor"] = {5, 1, 1};
    EXPECT_EQ(center(draw("material 0, emissiveFactor: more than 1, clamped"), "emission.R"), 1.0f);
}

TEST_F(RealFile, EqualConeAnglesAreAHardEdge) {
    const ExrPicture all = draw("");
    light()["type"] = "spot";
    // A radius of tan 0.5 = 0.55 on the square. A pixel is 3 m × 2 / 32 = 0.19 m wide.
    for (const double inner : {0.5, 0.50000001, 0.4999999999}) {
        light()["spot"] = {{"innerConeAngle", inner}, {"outerConeAngle", 0.5}};
        const ExrPicture spot = draw("");
        EXPECT_EQ(center(spot, "R"), center(all, "R"));
        EXPECT_EQ(spot.at("R", size / 2 + 1, size / 2), all.at("R", size / 2 + 1, size / 2));
        EXPECT_EQ(spot.at("R", size / 2 + 4, size / 2), 0.0f) << "at x = 0.84";
        EXPECT_GT(all.at("R", size / 2 + 4, size / 2), 0.0f);
    }
}

TEST_F(RealFile, ASpotLightWithoutItsConeIsNamedAndHasTheDefaultOne) {
    light()["type"] = "spot";
    const ExrPicture without = draw("note: light 0: a spot light without \"spot\"");
    light()["spot"] = Json::object();
    EXPECT_EQ(draw("").channels, without.channels);
}

TEST_F(RealFile, ARangeOfTheMaximumFloatIsNone) {
    light().erase("range");
    const ExrPicture without = draw("");
    for (const double range : {3.40282347e+38, 3.4028234663852886e+38, 1e39, 1e300, 1e30}) {
        light()["range"] = range;
        EXPECT_EQ(draw("light 0: range is more than any distance").channels, without.channels) << range;
    }
}

TEST_F(RealFile, AnAlphaEqualToTheCutoffIsOpaque) {
    const ExrPicture opaque = draw("");
    material()["alphaMode"] = "MASK";
    for (const double alpha : {0.5, 0.1, 0.9999, 128.0 / 255.0}) {
        material()["alphaCutoff"] = alpha;
        material()["pbrMetallicRoughness"]["baseColorFactor"][3] = alpha;
        EXPECT_EQ(draw("").channels.at("A"), opaque.channels.at("A")) << alpha;
        material()["alphaCutoff"] = alpha + 0.001;
        EXPECT_EQ(center(draw(""), "A"), 0.0f) << alpha;
    }
}

TEST_F(RealFile, ABlendedSurfaceIsTinted) {
    const ExrPicture opaque = draw("");
    material()["alphaMode"] = "BLEND";
    material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 0, 0, 0.4};
    const ExrPicture picture = draw("");
    EXPECT_EQ(center(opaque, "A"), 1.0f);
    EXPECT_NEAR(center(picture, "A"), 0.4f, 1.0e-5f);
    EXPECT_GT(center(picture, "R"), 2.0f * center(picture, "G"));
    material()["pbrMetallicRoughness"]["baseColorFactor"][3] = 0;
    EXPECT_EQ(center(draw(""), "A"), 0.0f) << "wholly transparent";
    material()["pbrMetallicRoughness"]["baseColorFactor"][3] = 0.4;
    EXPECT_NE(run({"--layers", "0"}).err.find("pixels of transparent surfaces are left out"),
              std::string::npos);
}

TEST_F(RealFile, AChildThatTheSceneListsIsDrawnOnce) {
    scene["nodes"].push_back({{"mesh", 0}, {"translation", {0.5, 0.25, 0.125}}});
    scene["nodes"][0]["children"] = {4};
    scene["nodes"][0]["translation"] = {-0.5, 0, 0};
    const ExrPicture legal = draw("");
    for (const Json& roots : {Json{0, 1, 2, 3, 4}, Json{4, 0, 1, 2, 3}}) {
        scene["scenes"][0]["nodes"] = roots;
        EXPECT_EQ(draw("node 4: a child, but listed by scene 0: drawn once").channels, legal.channels);
    }
}

/// A black picture of one row, as a data URI.
std::string blackRow(std::uint32_t width) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = 1;
    image.format = PNG_FORMAT_GRAY;
    const std::vector<std::uint8_t> pixels(width);
    std::vector<std::uint8_t> file(PNG_IMAGE_PNG_SIZE_MAX(image));
    png_alloc_size_t length = file.size();
    EXPECT_TRUE(png_image_write_to_memory(&image, file.data(), &length, 0, pixels.data(), 0, nullptr));
    std::string uri = "data:image/png,";
    for (std::size_t i = 0; i < length; ++i) {
        constexpr const char* digits = "0123456789ABCDEF";
        uri += {'%', digits[file[i] >> 4], digits[file[i] & 15u]};
    }
    return uri;
}

TEST_F(RealFile, ATextureThatTheDeviceCannotHoldIsNamedWithItsFile) {
    scene["images"] = {{{"name", "strip"}, {"uri", blackRow(20000)}}};
    scene["textures"] = {{{"source", 0}}};
    material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    scene["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 4;
    scene["accessors"].push_back({{"componentType", 5126}, {"count", 4}, {"type", "VEC2"}});
    const CommandResult result = run();
    if (result.exitCode == 0) GTEST_SKIP() << "this device holds textures of 20000 texels a side";
    expectFault(result, "scene.gltf", "image 0 'strip' is 20000x1 pixels");
}

TEST_F(RealFile, AFileThatIsMissingIsNamedAndTheRestDrawn) {
    scene["images"] = {{{"uri", "bricks.png"}}};
    scene["textures"] = {{{"source", 0}}};
    const ExrPicture without = draw("");
    material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    EXPECT_EQ(draw("note: image 0: file 'bricks.png': No such file").channels, without.channels);
}

}  // namespace
