// The images: size, content and the effect of the options.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace {

using Names = std::vector<std::string>;

/// The sample scene in a folder of its own; pictures are 32 × 32 pixels.
class Picture : public testing::Test {
  protected:
    Picture() { folder.write("square.gltf", sampleScene()); }

    CommandResult run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--size", "32x32", "--quiet"});
        return runCommand(arguments, {.folder = folder.path()});
    }
    PngPicture png(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"square.gltf", "-o", "test.png"});
        expectSuccess(run(arguments));
        return readPng(folder / "test.png");
    }
    ExrPicture exr(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"square.gltf", "-o", "test.exr"});
        expectSuccess(run(arguments));
        return readExr(folder / "test.exr");
    }

    TemporaryFolder folder;
};

/// The share of pixels that show a surface.
double coverage(const ExrPicture& picture) {
    double sum = 0.0;
    for (const float alpha : picture.channels.at("A")) sum += alpha;
    return sum / (picture.width * picture.height);
}

TEST_F(Picture, PlazaIsDrawnIntoTheDefaultFile) {
    expectSuccess(runCommand({"plaza:1000", "--size", "96x54"}, {.folder = folder.path()}));
    EXPECT_EQ(folder.names(), (Names{"candela.png", "square.gltf"}));
    const PngPicture picture = readPng(folder / "candela.png");
    EXPECT_EQ(picture.width, 96);
    EXPECT_EQ(picture.height, 54);
    EXPECT_TRUE(picture.opaque());
    EXPECT_GT(picture.colors(), 200u);
    EXPECT_GT(picture.mean(), 5.0);
}

TEST_F(Picture, IsTheSameOnNarrowerInstructionSets) {
    const auto draw = [&](const std::string& set) {
        expectSuccess(
            runCommand({"plaza:256", "-o", "test.exr", "--size", "96x54", "--device", "software", "--quiet"},
                       {.folder = folder.path(), .environment = {"CANDELA_INSTRUCTION_SET=" + set}}));
        return readExr(folder / "test.exr").channels;
    };
    const auto widest = draw(""), narrowest = draw("baseline");
    EXPECT_EQ(draw("baseline"), narrowest);
    double sum = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < widest.at("G").size(); ++i) {
        sum += widest.at("G")[i];
        difference += std::abs(widest.at("G")[i] - narrowest.at("G")[i]);
    }
    EXPECT_GT(sum, 0.0);
    // Estimated reciprocals and roots are exact to a few units in the last place, and sums have another
    // order.
    EXPECT_LE(difference, 1.0e-5 * sum);
#if defined(__x86_64__)
    // The baseline has no fused products, so that last bits differ.
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        EXPECT_NE(widest, narrowest);
    }
#endif
}

TEST_F(Picture, ExtensionsIgnoreCase) {
    expectSuccess(run({"square.gltf", "-o", "A.PNG"}));
    EXPECT_EQ(readPng(folder / "A.PNG").width, 32);
}

TEST_F(Picture, AnExistingFileIsReplaced) {
    folder.write("test.png", "old");
    EXPECT_EQ(png({}).width, 32);
    EXPECT_EQ(folder.names(), (Names{"square.gltf", "test.png"}));
}

TEST_F(Picture, ExposureBrightensPngOnly) {
    EXPECT_GT(png({"--exposure", "1"}).mean(), png({}).mean() + 1.0);
    EXPECT_LT(png({"--exposure", "-4"}).mean(), png({}).mean() - 1.0);
    EXPECT_EQ(exr({"--exposure", "1"}).channels, exr({}).channels);
}

TEST_F(Picture, BackgroundIsBlackAndOpaque) {
    const PngPicture picture = png({});
    EXPECT_TRUE(picture.opaque());
    // Corners lie outside the square; dither may lift black by one code value.
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_LE(picture.rgba[static_cast<std::size_t>(channel)], 1);
}

TEST_F(Picture, ExrHoldsRadianceAsFloats) {
    const ExrPicture picture = exr({});
    EXPECT_EQ(picture.names(), (Names{"A", "B", "G", "R"}));
    EXPECT_TRUE(picture.floats);
    EXPECT_TRUE(picture.chromaticities);
    EXPECT_EQ(picture.at("A", 16, 16), 1.0f);
    EXPECT_EQ(picture.at("A", 0, 0), 0.0f);
    EXPECT_EQ(picture.at("R", 0, 0), 0.0f);
    EXPECT_GT(picture.at("R", 16, 16), picture.at("G", 16, 16));
    EXPECT_GT(picture.at("G", 16, 16), picture.at("B", 16, 16));
    EXPECT_GT(picture.at("B", 16, 16), 0.0f);
}

TEST_F(Picture, AovsMatchTheSurface) {
    const ExrPicture picture = exr({"--aov", "all"});
    Names names{"A",
                "B",
                "G",
                "N.X",
                "N.Y",
                "N.Z",
                "P.X",
                "P.Y",
                "P.Z",
                "R",
                "Z",
                "base_color.B",
                "base_color.G",
                "base_color.R",
                "emission.B",
                "emission.G",
                "emission.R",
                "environment.B",
                "environment.G",
                "environment.R",
                "environment_diffuse.B",
                "environment_diffuse.G",
                "environment_diffuse.R",
                "environment_specular.B",
                "environment_specular.G",
                "environment_specular.R",
                "instance_id",
                "light_count",
                "material_id",
                "metallic",
                "motion.X",
                "motion.Y",
                "node_id",
                "roughness",
                "shadowed_count"};
#ifdef CANDELA_SHADOWS
    constexpr bool hasOcclusion = true;
#else
    constexpr bool hasOcclusion = false;
#endif
    if (hasOcclusion) names.insert(std::ranges::find(names, "base_color.B"), "ambient_occlusion");
    EXPECT_EQ(picture.names(), names);
    EXPECT_TRUE(picture.floats);
    // The pixel right below and right of the middle: half a pixel of 6 m / 32 from the axis.
    const float offset = 3.0f / 32.0f;
    const auto at = [&](const char* channel) { return picture.at(channel, 16, 16); };
    // Depth is float32 with 1 at the near plane of 0.1 m: at 3 m a step is some 2e-7 of it.
    EXPECT_NEAR(at("Z"), 3.0f, 1e-4f);
    EXPECT_NEAR(at("P.X"), offset, 1e-4f);
    EXPECT_NEAR(at("P.Y"), -offset, 1e-4f);
    EXPECT_NEAR(at("P.Z"), 0.0f, 1e-4f);
    // The normal shares 32 bits with roughness, and base colour has 8 bits a channel, sRGB-encoded.
    EXPECT_NEAR(at("N.X"), 0.0f, 2e-3f);
    EXPECT_NEAR(at("N.Y"), 0.0f, 2e-3f);
    EXPECT_NEAR(at("N.Z"), 1.0f, 2e-3f);
    EXPECT_NEAR(at("base_color.R"), 0.5f, 4e-3f);
    EXPECT_NEAR(at("base_color.G"), 0.25f, 4e-3f);
    EXPECT_NEAR(at("base_color.B"), 0.125f, 4e-3f);
    EXPECT_EQ(at("metallic"), 0.0f);
    EXPECT_NEAR(at("roughness"), 0.5f, 4e-3f);
    EXPECT_EQ(at("emission.R"), 0.0f);
    EXPECT_EQ(at("light_count"), 1.0f);
    EXPECT_EQ(picture.at("light_count", 0, 0), 0.0f);
    EXPECT_EQ(at("shadowed_count"), 0.0f);
    EXPECT_EQ(at("instance_id"), 1.0f);
    EXPECT_EQ(at("material_id"), 1.0f);
    EXPECT_GE(at("node_id"), 1.0f);
    EXPECT_EQ(picture.at("node_id", 0, 0), 0.0f);
    EXPECT_EQ(at("motion.X"), 0.0f);
    if (!hasOcclusion) return;
    EXPECT_EQ(at("ambient_occlusion"), 1.0f);
    EXPECT_EQ(picture.at("ambient_occlusion", 0, 0), 0.0f);
}

TEST_F(Picture, AovListSelectsChannels) {
    EXPECT_EQ(exr({"--aov", "Z,N"}).names(), (Names{"A", "B", "G", "N.X", "N.Y", "N.Z", "R", "Z"}));
}

TEST_F(Picture, CamerasAreFoundByNameAndIndex) {
    const ExrPicture first = exr({"--camera", "front"});
    EXPECT_EQ(first.channels, exr({}).channels);
    EXPECT_EQ(first.channels, exr({"--camera", "0"}).channels);
    const ExrPicture far = exr({"--camera", "far"});
    EXPECT_EQ(far.channels, exr({"--camera", "1"}).channels);
    // The square's side takes a third of the picture from 3 m and a sixth from 6 m, to a pixel.
    EXPECT_NEAR(std::sqrt(coverage(first)) * 32.0, 32.0 / 3.0, 1.0);
    EXPECT_NEAR(std::sqrt(coverage(far)) * 32.0, 32.0 / 6.0, 1.0);
}

TEST_F(Picture, EyeTargetAndFieldOfViewOverride) {
    const ExrPicture front = exr({"--aov", "Z"});
    const ExrPicture eye =
        exr({"--aov", "Z", "--camera", "far", "--eye", "0,0,3", "--target", "0,0,0", "--fov", "90"});
    EXPECT_NEAR(eye.at("Z", 16, 16), 3.0f, 1e-4f);
    EXPECT_NEAR(coverage(eye), coverage(front), 1e-9);
    EXPECT_GT(coverage(exr({"--fov", "45"})), 2.0 * coverage(front));
    EXPECT_EQ(coverage(exr({"--eye", "-1,0,3", "--target", "-1,0,6"})), 0.0);
}

TEST_F(Picture, WithoutACameraTheSceneIsFramed) {
    folder.write("square.gltf", sampleSceneWithoutCameras());
    const double normal = coverage(exr({}));
    EXPECT_GT(normal, 0.1);
    EXPECT_LT(normal, 0.95);
    // A narrow field of view moves the camera back, so the square stays about as large.
    EXPECT_NEAR(coverage(exr({"--fov", "10"})), normal, 0.5 * normal);
}

TEST_F(Picture, BrdfModelsDiffer) {
    EXPECT_EQ(exr({"--brdf", "course"}).channels, exr({}).channels);
    EXPECT_NE(exr({"--brdf", "gltf"}).channels, exr({}).channels);
}

TEST_F(Picture, TechniquesAgree) {
    const ExrPicture volumes = exr({"--technique", "volumes", "--scatter-lights", "50"});
    const ExrPicture fullscreen = exr({"--technique", "fullscreen", "--scatter-lights", "50"});
    for (const char* channel : {"R", "G", "B"})
        for (std::size_t i = 0; i < volumes.channels.at(channel).size(); ++i)
            // Sums of 51 lights in another order: a few units in the last place of single precision.
            EXPECT_NEAR(volumes.channels.at(channel)[i], fullscreen.channels.at(channel)[i],
                        1e-5f * (1.0f + std::abs(fullscreen.channels.at(channel)[i])));
}

TEST_F(Picture, ScatteredLightsAddLight) {
    EXPECT_GT(png({"--scatter-lights", "20,5,10"}).mean(), png({}).mean() + 1.0);
    EXPECT_EQ(exr({"--scatter-lights", "20"}).channels, exr({"--scatter-lights", "20"}).channels);
    EXPECT_EQ(exr({"--scatter-lights", "0"}).channels, exr({}).channels);
}

TEST_F(Picture, TimeMovesTheLight) {
    EXPECT_EQ(exr({"--time", "0"}).channels, exr({}).channels);
    const float near = exr({}).at("G", 16, 16);
    const float far = exr({"--time", "1"}).at("G", 16, 16);
    // From 1 m to 9 m: an 81st by distance, and the range window and the lobe change by less than a factor
    // of 2.
    EXPECT_LT(far, near / 40.0f);
    EXPECT_GT(far, near / 160.0f);
}

TEST_F(Picture, SoftwareDeviceDraws) {
    EXPECT_GT(png({"--device", "software"}).mean(), 0.5);
}

}  // namespace
