// Errors of files and of the environment: exit code 1, one line that names the file, and no output file.

#include "command.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

namespace {

using Names = std::vector<std::string>;

/// Runs in the folder, with a small picture.
CommandResult render(const TemporaryFolder& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--size", "32x32"});
    return runCommand(arguments, {.folder = folder.path()});
}

TEST(Fault, SceneFileIsMissing) {
    const TemporaryFolder folder;
    expectFault(render(folder, {"nowhere.gltf"}), "nowhere.gltf", "");
    EXPECT_EQ(folder.names(), Names{});
}

TEST(Fault, SceneFileIsBroken) {
    const TemporaryFolder folder;
    folder.write("broken.gltf", "{ this is no JSON");
    expectFault(render(folder, {"broken.gltf"}), "broken.gltf", "");
    folder.write("broken.glb", "glTF");
    expectFault(render(folder, {"broken.glb"}), "broken.glb", "");
    folder.write("empty.gltf", "");
    expectFault(render(folder, {"empty.gltf"}), "empty.gltf", "");
    EXPECT_EQ(folder.names(), (Names{"broken.glb", "broken.gltf", "empty.gltf"}));
}

#if defined(__x86_64__)
TEST(Fault, UnknownInstructionSetListsThoseOfTheProcessor) {
    const TemporaryFolder folder;
    const CommandResult result =
        runCommand({"plaza:4", "-o", "test.png", "--quiet"},
                   {.folder = folder.path(), .environment = {"CANDELA_INSTRUCTION_SET=sse9"}});
    expectFault(result, "CANDELA_INSTRUCTION_SET",
                "\"sse9\" names no instruction set; expected \"baseline\"");
    EXPECT_EQ(folder.names(), Names{});
}
#endif

TEST(Fault, NoPluginTakesTheScene) {
    const TemporaryFolder folder;
    folder.write("scene.xyz", "");
    expectFault(render(folder, {"scene.xyz"}), "scene.xyz", "xyz");
    expectFault(render(folder, {"castle:12"}), "castle:12", "");
    expectFault(render(folder, {"plaza:many"}), "plaza:many", "");
}

TEST(Fault, UnknownCameraListsTheAvailableOnes) {
    const TemporaryFolder folder;
    folder.write("square.gltf", sampleScene());
    for (const char* camera : {"back", "2", "-1", ""})
        expectFault(render(folder, {"square.gltf", "--quiet", "--camera", camera}), "square.gltf",
                    std::string("no camera \"") + camera + "\"; there are 0 \"front\", 1 \"far\"");
    folder.write("bare.gltf", sampleSceneWithoutCameras());
    expectFault(render(folder, {"bare.gltf", "--quiet", "--camera", "0"}), "bare.gltf", "the scene has none");
}

TEST(Fault, ColourConfigIsMissingOrBroken) {
    const TemporaryFolder folder;
    expectFault(render(folder, {"plaza:1", "--ocio", "no.ocio"}), "no.ocio", "");
    folder.write("broken.ocio", "ocio_profile_version: [");
    expectFault(render(folder, {"plaza:1", "--ocio", "broken.ocio"}), "broken.ocio", "");
    const CommandResult byEnvironment =
        runCommand({"plaza:1"}, {.folder = folder.path(), .environment = {"OCIO=broken.ocio"}});
    expectFault(byEnvironment, "broken.ocio", "");
}

TEST(Fault, UnknownColourNamesListTheAvailableOnes) {
    const TemporaryFolder folder;
    for (const char* option : {"--display", "--view", "--look"}) {
        const CommandResult result = render(folder, {"plaza:1", option, "cinema"});
        EXPECT_EQ(result.exitCode, 1) << option;
        EXPECT_TRUE(result.err.starts_with("candela-render: ")) << result.err;
        EXPECT_NE(result.err.find("cinema"), std::string::npos) << result.err;
    }
    EXPECT_NE(render(folder, {"plaza:1", "--display", "cinema"}).err.find("sRGB"), std::string::npos);
    EXPECT_EQ(folder.names(), Names{});
}

TEST(Fault, DeviceDoesNotExist) {
    const TemporaryFolder folder;
    const CommandResult result = render(folder, {"plaza:1", "--device", "99"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_TRUE(result.err.starts_with("candela-render: ")) << result.err;
    EXPECT_NE(result.err.find("99"), std::string::npos) << result.err;
    EXPECT_EQ(folder.names(), Names{});
}

TEST(Fault, PluginFolderDoesNotExist) {
    const TemporaryFolder folder;
    expectFault(render(folder, {"plaza:1", "--plugin-path", "nowhere"}), "nowhere", "");
}

// The output folder is checked before the scene is opened, which does not exist either.
TEST(Fault, OutputFolderIsMissing) {
    const TemporaryFolder folder;
    expectFault(render(folder, {"nowhere.gltf", "-o", "missing/a.png"}), "missing/a.png",
                "the folder missing does not exist");
    expectFault(render(folder, {"nowhere.gltf", "-o", "missing/a.exr"}), "missing/a.exr",
                "the folder missing does not exist");
    expectFault(render(folder, {"nowhere.gltf", "--stats", "missing/a.json"}), "missing/a.json",
                "the folder missing does not exist");
}

TEST(Fault, OutputIsAFolder) {
    const TemporaryFolder folder;
    mkdir((folder / "taken.png").c_str(), 0777);
    expectFault(render(folder, {"plaza:1", "-o", "taken.png"}), "taken.png", "is a folder");
    folder.write("file", "");
    expectFault(render(folder, {"plaza:1", "-o", "file/a.png"}), "file/a.png", "file is not a folder");
}

TEST(Fault, OutputFolderIsReadOnly) {
    // Not even root, who may write into any other folder, can create a file in /proc.
    expectFault(runCommand({"plaza:1", "--size", "32x32", "-o", "/proc/candela.png"}), "/proc/candela.png",
                "");
    expectFault(runCommand({"plaza:1", "--size", "32x32", "--stats", "/proc/candela.json", "-o",
                            "/proc/candela.png"}),
                "/proc/candela.png", "");
    if (geteuid() == 0) return;
    const TemporaryFolder folder;
    mkdir((folder / "closed").c_str(), 0555);
    expectFault(render(folder, {"nowhere.gltf", "-o", "closed/a.png"}), "closed/a.png",
                "cannot be written to");
}

/// Limits files of this process and its children to one byte, as on a full disk.
void fillDisk() {
    const rlimit limit{1, 1};
    setrlimit(RLIMIT_FSIZE, &limit);
}

TEST(Fault, FullDiskWritesNoImageAndKeepsAnExistingOne) {
    for (const char* name : {"a.png", "a.exr"}) {
        const TemporaryFolder folder;
        const CommandSetting setting{.folder = folder.path(), .beforeStart = fillDisk};
        expectFault(runCommand({"plaza:4", "--size", "64x64", "-o", name}, setting), name, "");
        EXPECT_EQ(folder.names(), Names{});
        folder.write(name, "an older picture");
        expectFault(runCommand({"plaza:4", "--size", "64x64", "-o", name}, setting), name, "");
        EXPECT_EQ(folder.names(), Names{name});
        EXPECT_EQ(std::filesystem::file_size(folder.path() / name), std::string("an older picture").size());
    }
}

TEST(Fault, FullFileSystemWritesNoImage) {
    const TemporaryFolder folder;
    const std::string disk = folder / "disk";
    mkdir(disk.c_str(), 0777);
    if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=4k") != 0)
        GTEST_SKIP() << "cannot mount a small file system: " << std::strerror(errno);
    const CommandResult result = render(folder, {"plaza:4", "-o", "disk/a.exr", "--aov", "all"});
    const bool empty = std::filesystem::is_empty(disk);
    umount(disk.c_str());
    expectFault(result, "disk/a.exr", "");
    EXPECT_TRUE(empty);
}

TEST(Fault, StatsToAFullDevice) {
    const TemporaryFolder folder;
    const CommandResult result = render(folder, {"plaza:4", "--stats", "/dev/full", "--quiet"});
    expectFault(result, "/dev/full", std::strerror(ENOSPC));
    EXPECT_EQ(folder.names(), Names{"candela.png"});
}

TEST(Fault, NothingToScatterLightsOver) {
    const TemporaryFolder folder;
    folder.write("empty.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{}], "scene": 0})");
    expectFault(render(folder, {"empty.gltf", "--scatter-lights", "10"}), "empty.gltf", "no surface");
}

}  // namespace
