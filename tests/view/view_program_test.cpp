// Tests of the program candela-view, interactive and scripted.

#include "command.h"
#include "own_display.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

namespace {

using namespace std::chrono_literals;
using Json = nlohmann::json;
using Words = std::vector<std::string>;
using Clock = std::chrono::steady_clock;

/// Runs the program in a temporary folder, which holds its settings too.
class ViewProgram : public testing::Test {
  protected:
    ViewProgram() { folder.write("square.gltf", sampleScene()); }
    void SetUp() override {
        if (!takeOwnDisplay().empty()) GTEST_SKIP() << takeOwnDisplay();
    }

    CommandSetting here() const {
        return {.folder = folder.path(), .environment = {"XDG_CONFIG_HOME=" + (folder / "config")}};
    }
    CommandResult run(const Words& arguments) const { return runCommand(arguments, here()); }
    void render(Words arguments, const std::string& output) const {
        // What candela-view writes for a script.
        arguments.insert(arguments.end(), {"--samples", "1", "-o", output, "--quiet"});
        expectSuccess(runCommand(arguments, {.folder = folder.path(), .program = CANDELA_RENDER}));
    }

    /// Runs a session that is not scripted, until `ready`, and ends it by a signal.
    CommandResult session(const Words& arguments, const std::function<bool(int)>& ready,
                          int signal = SIGTERM) const {
        CommandSetting setting = here();
        setting.whileRunning = [&](int child) {
            const auto end = Clock::now() + 60s;
            while (!ready(child) && Clock::now() < end) std::this_thread::sleep_for(20ms);
            EXPECT_LT(Clock::now(), end) << "the session does not become ready";
            kill(child, signal);
        };
        return runCommand(arguments, setting);
    }

    TemporaryFolder folder;
};

/// The processor time that a process has used so far, seconds.
double processorTime(int process) {
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    std::string text((std::istreambuf_iterator<char>(stat)), {});
    std::istringstream fields(text.substr(text.rfind(')') + 1));
    std::string skipped;
    for (int i = 0; i < 11; ++i) fields >> skipped;
    double user = 0.0, system = 0.0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// Whether a session has drawn its scene and is idle: it uses no more than 2 % of a CPU for a second.
bool isIdle(int process) {
    const double before = processorTime(process);
    std::this_thread::sleep_for(1s);
    return before > 0.05 && processorTime(process) - before <= 0.02;
}

std::string bytesOf(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

TEST_F(ViewProgram, HelpNamesItsOptions) {
    const CommandResult result = run({"--help"});
    expectSuccess(result);
    EXPECT_EQ(result.err, "");
    for (const char* word : {"--screenshot", "--window-screenshot", "--frames", "--reset", "--scatter-lights",
                             "--eye", "--camera", "--ocio", "--display", "--technique", "--brdf", "SCENE"})
        EXPECT_NE(result.out.find(word), std::string::npos) << word;
    EXPECT_NE(run({"--version"}).out.find(CANDELA_VERSION), std::string::npos);
}

TEST_F(ViewProgram, WrongUsageIsAnErrorInOneLine) {
    expectUsageError(run({"--nonsense"}), "--nonsense");
    expectUsageError(run({"plaza:1", "--frames", "0"}), "--frames");
    expectUsageError(run({"plaza:1", "--screenshot", "a.jpg"}), ".png or .exr");
    expectUsageError(run({"plaza:1", "--window-screenshot", "a.exr"}), ".png");
    expectUsageError(run({"--screenshot", "a.png"}), "SCENE");
    expectUsageError(run({"plaza:1", "--eye", "1,2,3"}), "--target");
    EXPECT_EQ(folder.names(), Words{"square.gltf"});
}

TEST_F(ViewProgram, WithoutADisplayItNamesCandelaRender) {
    CommandSetting setting = here();
    setting.beforeStart = [] {
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
    };
    for (const Words& arguments : {Words{"plaza:64"}, Words{"plaza:64", "--screenshot", "a.png"}}) {
        const CommandResult result = runCommand(arguments, setting);
        EXPECT_EQ(result.exitCode, 1);
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_NE(result.err.find("candela-render"), std::string::npos) << result.err;
        EXPECT_NE(result.err.find("display"), std::string::npos) << result.err;
    }
    EXPECT_EQ(folder.names(), Words{"square.gltf"});
}

TEST_F(ViewProgram, ScreenshotsAreTheFilesOfCandelaRender) {
    const std::array<Words, 13> cases{
        Words{"plaza:64"},
        Words{"plaza:64", "--eye", "3,4,5", "--target", "0,1,0", "--fov", "60"},
        Words{"square.gltf"},
        Words{"square.gltf", "--camera", "far", "--time", "0.25"},
        Words{"plaza:64", "--display", "Display P3", "--view", "Raw", "--exposure", "1.5"},
        Words{"plaza:64", "--brdf", "gltf"},
        Words{"plaza:64", "--technique", "volumes"},
        Words{"plaza:64", "--show", "normals"},
        Words{"plaza:64", "--show", "light_count,wireframe"},
        Words{"sculpture:64", "--subdivision-level", "2"},
        Words{"sculpture:64", "--show", "level,cage", "--subdivision-edge", "20"},
        Words{"square.gltf", "--scatter-lights", "50,1,0.5,7"},
        Words{"square.gltf", "--scatter-lights", "50", "--camera", "1"},
    };
    for (Words arguments : cases) {
        arguments.insert(arguments.end(), {"--size", "200x120"});
        render(arguments, "expected.png");
        arguments.insert(arguments.end(), {"--screenshot", "shown.png"});
        const CommandResult result = run(arguments);
        expectSuccess(result);
        EXPECT_EQ(result.err, "");
        EXPECT_TRUE(bytesOf(folder / "shown.png") == bytesOf(folder / "expected.png"))
            << testing::PrintToString(arguments);
        std::filesystem::remove(folder / "shown.png");
    }
}

TEST_F(ViewProgram, AnExrHoldsEveryChannelOfCandelaRender) {
    for (const char* samples : {"1", "3"}) {
        const Words picture{"square.gltf", "--size", "64x48", "--samples", samples};
        Words all = picture, screenshot = picture;
        all.insert(all.end(), {"--aov", "all", "-o", "expected.exr", "--quiet"});
        screenshot.insert(screenshot.end(), {"--screenshot", "shown.EXR"});
        expectSuccess(runCommand(all, {.folder = folder.path(), .program = CANDELA_RENDER}));
        expectSuccess(run(screenshot));
        const ExrPicture shown = readExr(folder / "shown.EXR");
        ExrPicture expected = readExr(folder / "expected.exr");
        EXPECT_TRUE(shown.channels == expected.channels) << samples << " samples";
        // Only candela-render describes its camera.
        for (const char* name : {"cameraLabel", "colorInteropID", "software", "workingSpace"}) {
            EXPECT_EQ(expected.texts.erase(name), 1u) << name;
        }
        EXPECT_EQ(shown.texts, expected.texts);
        EXPECT_GT(shown.channels.size(), 15u);
    }
}

TEST_F(ViewProgram, DrawsSizesBeyondTheScreen) {
    render({"square.gltf", "--size", "1001x703"}, "expected.png");
    expectSuccess(run({"square.gltf", "--size", "1001x703", "--frames", "3", "--screenshot", "shown.png"}));
    EXPECT_TRUE(bytesOf(folder / "shown.png") == bytesOf(folder / "expected.png"));
}

TEST_F(ViewProgram, AFailedScriptReportsTheErrorAndWritesNothing) {
    folder.write("broken.gltf", "{");
    expectFault(run({"absent.gltf", "--screenshot", "a.png"}), "absent.gltf", "");
    expectFault(run({"broken.gltf", "--screenshot", "a.png"}), "broken.gltf", "");
    expectFault(run({"absent.gltf", "--frames", "2"}), "absent.gltf", "");
    expectFault(run({"square.gltf", "--camera", "unknown", "--frames", "2"}), "square.gltf", "unknown");
    expectFault(run({"square.gltf", "--screenshot", "nowhere/a.png"}), "nowhere/a.png", "does not exist");
    expectFault(run({"square.gltf", "--window-screenshot", "nowhere/a.png"}), "nowhere/a.png",
                "does not exist");
    expectFault(run({"square.gltf", "--ocio", "absent.ocio", "--screenshot", "a.png"}), "absent.ocio", "");
    EXPECT_EQ(folder.names(), (Words{"broken.gltf", "square.gltf"})) << "and no settings";
}

TEST_F(ViewProgram, AWindowScreenshotShowsImageAndPanels) {
    expectSuccess(
        run({"plaza:64", "--size", "640x400", "--window-screenshot", "window.png", "--screenshot", "p.png"}));
    const PngPicture window = readPng(folder / "window.png"), picture = readPng(folder / "p.png");
    ASSERT_EQ(window.width, 640);
    ASSERT_EQ(window.height, 400);
    EXPECT_TRUE(window.opaque());
    EXPECT_EQ(picture.width, 640) << "the picture has the size of the command line";
    const auto at = [&](int x, int y) {
        return &window.rgba[static_cast<std::size_t>(4 * (y * window.width + x))];
    };
    // At the left, under the menu bar, the panel of the scene is as grey as all panels.
    for (int y = 60; y < 110; ++y) EXPECT_LE(std::abs(int{at(3, y)[0]} - int{at(3, y)[2]}), 4) << y;
    // In the middle, what candela-render draws of the size that the panels leave: each column takes 0.3 of
    // the width at most.
    bool colored = false;
    for (int y = 150; y < 280; ++y)
        colored = colored || std::abs(int{at(320, y)[0]} - int{at(320, y)[2]}) > 8;
    EXPECT_TRUE(colored);
}

TEST_F(ViewProgram, AWindowWithoutASceneHasAScreenshotToo) {
    expectSuccess(run({"--size", "320x200", "--window-screenshot", "window.png"}));
    EXPECT_EQ(readPng(folder / "window.png").width, 320);
    expectSuccess(run({"--size", "320x200", "--frames", "2"}));
}

TEST_F(ViewProgram, AnIdleWindowUsesNoProcessor) {
    double used = 1.0;
    const CommandResult result = session({"plaza:64", "--size", "320x240"}, [&](int child) {
        if (!isIdle(child)) return false;
        const double before = processorTime(child);
        std::this_thread::sleep_for(2s);
        used = processorTime(child) - before;
        return true;
    });
    expectSuccess(result);
    // A clock tick is 0.01 s. One frame of the panels alone takes that long here: 0.02 s in 2 s leave room
    // for none or one.
    EXPECT_LE(used, 0.02);
}

TEST_F(ViewProgram, SettingsSurviveTheSession) {
    EXPECT_EQ(
        session({"square.gltf", "--size", "333x222", "--exposure", "1.5", "--brdf", "gltf"}, isIdle).exitCode,
        0);
    const Json first = Json::parse(bytesOf(folder / "config/candela/view.json"));
    EXPECT_EQ(first["size"], (Json{333, 222}));
    EXPECT_FALSE(first.contains("exposure")) << "it is that of a scene";
    EXPECT_EQ(first["brdf"], "gltf");
    EXPECT_EQ(first["recent"], (Json{folder / "square.gltf"}));
    EXPECT_TRUE(std::filesystem::exists(folder / "config/candela/view-layout.ini"));

    // Values that are not given are read from the settings; a script neither reads nor writes them.
    EXPECT_EQ(session({"plaza:16", "--exposure", "-1"}, isIdle, SIGINT).exitCode, 0);
    const std::string second = bytesOf(folder / "config/candela/view.json");
    EXPECT_EQ(Json::parse(second)["size"], (Json{333, 222}));
    EXPECT_EQ(Json::parse(second)["brdf"], "gltf");
    EXPECT_EQ(Json::parse(second)["recent"], (Json{"plaza:16", folder / "square.gltf"}));
    render({"square.gltf", "--size", "64x64"}, "expected.png");
    expectSuccess(run({"square.gltf", "--size", "64x64", "--screenshot", "shown.png"}));
    EXPECT_TRUE(bytesOf(folder / "shown.png") == bytesOf(folder / "expected.png"));
    EXPECT_EQ(bytesOf(folder / "config/candela/view.json"), second);

    EXPECT_EQ(session({"--reset"}, isIdle, SIGHUP).exitCode, 0);
    const Json third = Json::parse(bytesOf(folder / "config/candela/view.json"));
    EXPECT_EQ(third["size"], (Json{1280, 720}));
    EXPECT_EQ(third["brdf"], "course");
    EXPECT_TRUE(third["recent"].empty());
}

TEST_F(ViewProgram, InvalidSettingsDoNotStopTheProgram) {
    std::filesystem::create_directories(folder / "config/candela");
    folder.write("config/candela/view.json", "{\"size\": \"large\"}");
    EXPECT_EQ(session({"square.gltf", "--size", "320x240"}, isIdle).exitCode, 0);
    EXPECT_EQ(Json::parse(bytesOf(folder / "config/candela/view.json"))["size"], (Json{320, 240}));
}

TEST_F(ViewProgram, AMissingConfigOfTheLastSessionDoesNotStopTheProgram) {
    folder.write("gone.ocio",
                 "ocio_profile_version: 2\n"
                 "roles:\n  default: raw\n  scene_linear: raw\n"
                 "displays:\n  Monitor:\n    - !<View> {name: Plain, colorspace: raw}\n"
                 "colorspaces:\n  - !<ColorSpace> {name: raw, isdata: true}\n");
    EXPECT_EQ(session({"square.gltf", "--size", "320x240", "--ocio", "gone.ocio"}, isIdle).exitCode, 0);
    EXPECT_EQ(Json::parse(bytesOf(folder / "config/candela/view.json"))["ocio"], "gone.ocio");
    std::filesystem::remove(folder / "gone.ocio");
    EXPECT_EQ(session({"square.gltf"}, isIdle).exitCode, 0);
    EXPECT_EQ(Json::parse(bytesOf(folder / "config/candela/view.json"))["ocio"], "");
}

TEST_F(ViewProgram, SettingsThatCanNotBeWrittenAreANote) {
    folder.write("config", "no folder");
    const CommandResult result = session({"square.gltf", "--size", "320x240"}, isIdle);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_TRUE(result.err.starts_with("note: ")) << result.err;
    EXPECT_NE(result.err.find("config"), std::string::npos) << result.err;
}

TEST_F(ViewProgram, EndsCleanlyWhileASceneIsRead) {
    EXPECT_EQ(
        session({"plaza:2000000", "--size", "320x240"}, [](int child) { return processorTime(child) > 0.5; })
            .exitCode,
        0);
}

TEST_F(ViewProgram, ASceneThatFailsLeavesTheWindowOpen) {
    EXPECT_EQ(session({"absent.gltf", "--size", "320x240"}, isIdle).exitCode, 0);
}

}  // namespace
