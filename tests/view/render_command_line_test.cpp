// The copied command line, parsed by a shell and then by the options of candela-render.

#include "render_command_line.h"
#include "common/program.h"
#include "common/shadow_stats.h"

#include <CLI/CLI.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace {

using Words = std::vector<std::string>;

/// The arguments into which /bin/sh splits a command.
Words wordsOf(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> shell(popen(("printf '%s\\0' " + command).c_str(), "r"),
                                                      pclose);
    if (!shell) throw std::runtime_error("no shell can be started");
    Words words;
    std::string word;
    for (int c = std::getc(shell.get()); c != EOF; c = std::getc(shell.get())) {
        if (c != 0) {
            word += static_cast<char>(c);
            continue;
        }
        words.push_back(word);
        word.clear();
    }
    return words;
}

/// The options that candela-render parses from a command.
SceneOptions readBack(const std::string& command) {
    CLI::App app;
    SceneOptions options;
    SceneOptionReader reader(app, options, 16);
    std::string output;
    app.add_option("-o", output);
    Words words = wordsOf(command);
    EXPECT_EQ(words.at(0), "candela-render");
    std::vector<const char*> pointers;
    for (const std::string& word : words) pointers.push_back(word.c_str());
    app.parse(static_cast<int>(pointers.size()), pointers.data());
    reader.finish();
    return options;
}

SceneOptions readBack(const SceneOptions& options) {
    return readBack(renderCommandLine(options));
}

SceneOptions someScene() {
    SceneOptions options;
    options.scene = "plaza:64";
    return options;
}

TEST(RenderCommandLine, NamesSceneSizeAndOutput) {
    EXPECT_EQ(
        renderCommandLine(someScene()),
        "candela-render plaza:64 --size 1280x720 --samples 64 --brdf course --technique auto -o candela.png");
}

TEST(RenderCommandLine, QuotesNamesForAShell) {
    for (const char* name :
         {"two words.gltf", "it's.gltf", "''", "$HOME.gltf", "`date`.gltf", "a\"b\\c.gltf", "~/x.gltf",
          "a\nb.gltf", "*.gltf", "a;b&c|d<e>f(g)h!.gltf", "#a.gltf", "Z\xc3\xbcrich.gltf", "-dash.gltf"}) {
        SceneOptions options;
        options.scene = name;
        const std::string read = readBack(options).scene;
        // A file whose name begins with a dash is reached by its folder.
        EXPECT_EQ(read, (*name == '-' ? std::string("./") : std::string()) + name);
    }
}

TEST(RenderCommandLine, PreservesNamesThatLookLikeOptions) {
    SceneOptions options = someScene();
    options.camera = "--eye";
    options.display.look = "-o";
    options.display.view = "ACES 1.0 SDR";
    options.ocio = "my 'own'.ocio";
    options.lights = "-lights of 'mine'.gltf";
    const SceneOptions read = readBack(options);
    EXPECT_EQ(read.camera, "--eye");
    EXPECT_EQ(read.display.look, "-o");
    EXPECT_EQ(read.display.view, "ACES 1.0 SDR");
    EXPECT_EQ(read.ocio, "my 'own'.ocio");
    EXPECT_EQ(read.lights, "-lights of 'mine'.gltf");
}

TEST(RenderCommandLine, PreservesNumbersExactly) {
    SceneOptions options = someScene();
    options.eye = EyeOptions{{-1.0f / 3.0f, 1.0e-9f, 123456.789f}, {0.1f, -0.0f, 16777216.0f}};
    options.time = 1.0 / 7.0;
    options.display.exposure = -0.1;
    options.subdivision.edgePixels = 1.0f / 3.0f;
    options.scatter = candela::LightScatter{1000, 2.0f / 3.0f, 0.7f, 4294967295u};
    const SceneOptions read = readBack(options);
    ASSERT_TRUE(read.eye);
    EXPECT_EQ(read.eye->eye, options.eye->eye);
    EXPECT_EQ(read.eye->target, options.eye->target);
    EXPECT_EQ(read.time, options.time);
    EXPECT_EQ(read.display.exposure, options.display.exposure);
    EXPECT_EQ(read.subdivision.edgePixels, options.subdivision.edgePixels);
    ASSERT_TRUE(read.scatter);
    EXPECT_EQ(read.scatter->count, 1000u);
    EXPECT_EQ(read.scatter->range, options.scatter->range);
    EXPECT_EQ(read.scatter->candela, options.scatter->candela);
    EXPECT_EQ(read.scatter->seed, options.scatter->seed);
}

TEST(RenderCommandLine, PreservesEveryFieldOfView) {
    // The option is in degrees: the round trip must preserve the radians exactly.
    for (float radians = 0.01f; radians < std::numbers::pi_v<float> - 0.01f; radians *= 1.0071f) {
        SceneOptions options = someScene();
        options.verticalFov = radians;
        const std::string command = renderCommandLine(options);
        const std::size_t start = command.find("--fov ") + 6;
        const double degrees = std::stod(command.substr(start));
        // As the option reader converts it; a shell for each of these numbers would take long.
        EXPECT_EQ(static_cast<float>(degrees * std::numbers::pi / 180.0), radians);
    }
}

TEST(RenderCommandLine, PreservesStrictness) {
    SceneOptions options = someScene();
    EXPECT_EQ(readBack(options).strictness, candela::Strictness::tolerant);
    options.strictness = candela::Strictness::strict;
    EXPECT_EQ(readBack(options).strictness, candela::Strictness::strict);
}

TEST(RenderCommandLine, PreservesEnumerationsAndLists) {
    SceneOptions options = someScene();
    options.width = 7;
    options.height = 16384;
    options.brdf = candela::BrdfModel::gltf;
    options.technique = candela::Technique::volumes;
    options.debug.view = candela::DebugView::lightCount;
    options.debug.overlays = {.wireframe = true, .cage = true};
    options.subdivision.level = 3;
    options.subdivision.maxLevel = 7;
    options.vertexEvaluator = candela::VertexEvaluator::compute;
    options.threads = 3;
    options.tileBackend = candela::TileBackend::cpu;
    options.rangeLoss = 0.25f;
    options.defaultLights = DefaultLights::off;
    options.autoExposure = true;
    options.pluginFolders = {"one folder", "other"};
    options.display.display = "Display P3";
    const SceneOptions read = readBack(options);
    EXPECT_EQ(read.width, 7);
    EXPECT_EQ(read.height, 16384);
    EXPECT_EQ(read.brdf, candela::BrdfModel::gltf);
    EXPECT_EQ(read.technique, candela::Technique::volumes);
    EXPECT_EQ(read.debug.view, candela::DebugView::lightCount);
    EXPECT_TRUE(read.debug.overlays.wireframe);
    EXPECT_TRUE(read.debug.overlays.cage);
    EXPECT_EQ(read.subdivision.level, 3u);
    EXPECT_EQ(read.subdivision.maxLevel, 7u);
    EXPECT_EQ(read.vertexEvaluator, candela::VertexEvaluator::compute);
    EXPECT_EQ(read.threads, 3u);
    EXPECT_EQ(read.tileBackend, candela::TileBackend::cpu);
    EXPECT_EQ(read.rangeLoss, 0.25f);
    EXPECT_EQ(read.defaultLights, DefaultLights::off);
    EXPECT_TRUE(read.autoExposure);
    EXPECT_EQ(read.pluginFolders, options.pluginFolders);
    EXPECT_EQ(read.display.display, "Display P3");
}

TEST(RenderCommandLine, PreservesSamplesLensAndShutter) {
    SceneOptions options = someScene();
    EXPECT_EQ(readBack(options).sampling.count, 64u) << "the view's own default";
    options.sampling = {.count = 9,
                        .fNumber = 1.0f / 3.0f,
                        .focusDistance = 2.7f,
                        .blades = 7,
                        .shutter = 1.0 / 3.0,
                        .framesPerSecond = 30.0};
    const SamplingOptions read = readBack(options).sampling;
    EXPECT_EQ(read.count, 9u);
    EXPECT_EQ(read.fNumber, options.sampling.fNumber);
    EXPECT_EQ(read.focusDistance, options.sampling.focusDistance);
    EXPECT_EQ(read.blades, 7u);
    EXPECT_EQ(read.shutter, options.sampling.shutter);
    EXPECT_EQ(read.framesPerSecond, 30.0);
    options.debug.view = candela::DebugView::normals;
    EXPECT_EQ(renderCommandLine(options).find("--samples"), std::string::npos) << "it has one";
}

TEST(RenderCommandLine, PreservesTheEnvironment) {
    using enum EnvironmentOption::Source;
    const auto readOf = [](const EnvironmentOption& environment) {
        SceneOptions options = someScene();
        options.environment = environment;
        return readBack(options).environment;
    };
    const auto expectSame = [&](const EnvironmentOption& option) {
        const EnvironmentOption read = readOf(option);
        EXPECT_EQ(read.source, option.source);
        EXPECT_EQ(read.file, option.file);
        EXPECT_EQ(read.degrees, option.degrees);
        EXPECT_EQ(read.stops, option.stops);
    };
    expectSame({});
    expectSame({none, "", 0.0, 0.0});
    expectSame({studio, "", 0.0, 1.5});
    expectSame({sky, "", -90.125, 0.0});
    expectSame({file, "a folder/it's, a sky.HDR", 1.0 / 3.0, -2.0});
    expectSame({file, "a,12.hdr", 0.0, 0.0});
    SceneOptions options = someScene();
    EXPECT_FALSE(readBack(options).background);
    options.background = false;
    EXPECT_EQ(readBack(options).background, false);
}

TEST(RenderCommandLine, NamesShadowsWhereTheyAreNotTheDefault) {
    using enum candela::Shadows;
    SceneOptions options = someScene();
    const candela::Shadows standard = drawnShadows(options.shadows);
    options.shadows = standard;
    EXPECT_EQ(renderCommandLine(options).find("--shadows"), std::string::npos);
    options.shadows = off;
    EXPECT_EQ(drawnShadows(readBack(options).shadows), off);
    if (!candela::hasShadows()) return;
    options.shadows = on;
    EXPECT_EQ(drawnShadows(readBack(options).shadows), on);
    options.shadows = standard == on ? off : on;
    EXPECT_NE(renderCommandLine(options).find(std::string("--shadows ") + toString(options.shadows)),
              std::string::npos);
}

TEST(RenderCommandLine, NamesSpecularAntialiasingWhereItIsOff) {
    SceneOptions options = someScene();
    EXPECT_EQ(renderCommandLine(options).find("--specular-aa"), std::string::npos);
    options.specularAntialiasing = false;
    EXPECT_FALSE(readBack(options).specularAntialiasing);
}

TEST(RenderCommandLine, NamesLayersWhereTheyAreNotTheDefault) {
    SceneOptions options = someScene();
    EXPECT_EQ(renderCommandLine(options).find("--layers"), std::string::npos);
    options.layers = 12;
    EXPECT_EQ(readBack(options).layers, 12u);
}

TEST(RenderCommandLine, NamesTheRaysOfTheEnvironmentWhereTheyAreNotTheDefault) {
    SceneOptions options = someScene();
    EXPECT_EQ(renderCommandLine(options).find("--environment-rays"), std::string::npos);
    options.environmentRays = 9;
    EXPECT_EQ(readBack(options).environmentRays, 9u);
}

TEST(RenderCommandLine, KeepsTheSizesOfPointsAndLines) {
    SceneOptions options = someScene();
    EXPECT_EQ(renderCommandLine(options).find("--point-size"), std::string::npos);
    EXPECT_EQ(renderCommandLine(options).find("--line-width"), std::string::npos);
    options.pointSize = 1.0f / 3.0f;
    options.lineWidth = 7.5f;
    EXPECT_EQ(readBack(options).pointSize, options.pointSize);
    EXPECT_EQ(readBack(options).lineWidth, options.lineWidth);
}

TEST(RenderCommandLine, KeepsTheLensAndTheAnimation) {
    SceneOptions options = someScene();
    options.orthographicHeight = 1.0f / 3.0f;
    options.animation = "--all";
    options.repeatAnimations = true;
    const SceneOptions read = readBack(options);
    EXPECT_EQ(read.orthographicHeight, options.orthographicHeight);
    EXPECT_EQ(read.animation, "--all");
    EXPECT_TRUE(read.repeatAnimations);
    EXPECT_FALSE(readBack(someScene()).orthographicHeight);
    EXPECT_FALSE(readBack(someScene()).animation);
    EXPECT_FALSE(readBack(someScene()).repeatAnimations);
}

TEST(RenderCommandLine, PrefersAnEyeToACamera) {
    SceneOptions options = someScene();
    options.camera = "front";
    EXPECT_EQ(readBack(options).camera, "front");
    options.eye = EyeOptions{{1.0f, 2.0f, 3.0f}, {0.0f, 0.0f, 0.0f}};
    EXPECT_FALSE(readBack(options).camera);
}

}  // namespace
