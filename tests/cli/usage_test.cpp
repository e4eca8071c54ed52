// Errors of the command line (exit code 2, one line), --help and --version.

#include "command.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <array>

namespace {

struct BadUsage {
    std::vector<std::string> arguments;
    std::string reason;
};

TEST(Usage, EveryErrorIsNamed) {
    const std::array mistakes{
        BadUsage{{}, "SCENE is missing"},
        BadUsage{{"--quiet"}, "SCENE is missing"},
        BadUsage{{"plaza:1", "--no-such-option"}, "--no-such-option"},
        BadUsage{{"plaza:1", "plaza:2"}, "plaza:2"},
        BadUsage{{"plaza:1", "--size"}, "--size"},
        BadUsage{{"plaza:1", "--size", "0x5"}, "whole number from 1 to 65536"},
        BadUsage{{"plaza:1", "--tile", "63"}, "whole number from 64 to 16384"},
        BadUsage{{"plaza:1", "--tile", "64", "--show", "depth"}, "can not be drawn in parts"},
        BadUsage{{"plaza:1", "--panorama", "--size", "64x64"}, "twice as wide as high"},
        BadUsage{{"plaza:1", "--panorama", "-o", "a.exr", "--aov", "Z,motion"}, "has no AOV motion"},
        BadUsage{{"plaza:1", "--panorama", "--show", "wireframe"}, "--panorama"},
        BadUsage{{"plaza:1", "--panorama", "--tile", "64"}, "--panorama"},
        BadUsage{{"plaza:1", "--size", "5x0"}, "whole number from 1 to 65536"},
        BadUsage{{"plaza:1", "--size", "65537x5"}, "whole number from 1 to 65536"},
        BadUsage{{"plaza:1", "--size", "99999999999999999999x5"}, "whole number from 1 to 65536"},
        BadUsage{{"plaza:1", "--size", "640"}, "WIDTHxHEIGHT"},
        BadUsage{{"plaza:1", "--size", "640x360x3"}, "\"360x3\""},
        BadUsage{{"plaza:1", "--size", "64.5x36"}, "\"64.5\""},
        BadUsage{{"plaza:1", "--size", "64x36", "--size", "32x18"}, "--size"},
        BadUsage{{"plaza:1", "-o", "picture.jpg"}, ".png or .exr"},
        BadUsage{{"plaza:1", "-o", "picture"}, ".png or .exr"},
        BadUsage{{"plaza:1", "--technique", "magic"}, "auto, volumes, tiles, fullscreen"},
        BadUsage{{"plaza:1", "--brdf", "phong"}, "course, gltf"},
        BadUsage{{"plaza:1", "--eye", "0,0,1"}, "--eye needs --target"},
        BadUsage{{"plaza:1", "--target", "0,0,1"}, "--target needs --eye"},
        BadUsage{{"plaza:1", "--eye", "0,0", "--target", "0,0,1"}, "three numbers X,Y,Z"},
        BadUsage{{"plaza:1", "--eye", "0,0,nan", "--target", "0,0,1"}, "three numbers X,Y,Z"},
        BadUsage{{"plaza:1", "--eye", "0,0,1", "--target", "0,0,1"}, "another point"},
        BadUsage{{"plaza:1", "--fov", "0"}, "between 0 and 180"},
        BadUsage{{"plaza:1", "--fov", "180"}, "between 0 and 180"},
        BadUsage{{"plaza:1", "--fov", "wide"}, "between 0 and 180"},
        BadUsage{{"plaza:1", "--exposure", "bright"}, "between -64 and 64"},
        BadUsage{{"plaza:1", "--exposure", "inf"}, "between -64 and 64"},
        BadUsage{{"plaza:1", "--scatter-lights", "-1"}, "whole number"},
        BadUsage{{"plaza:1", "--scatter-lights", "10,0"}, "--scatter-lights"},
        BadUsage{{"plaza:1", "--scatter-lights", "10,1,1,1,1"}, "N[,RANGE[,CANDELA[,SEED]]]"},
        BadUsage{{"plaza:1", "--scatter-lights", "10,1,1,-1"}, "whole number from 0"},
        BadUsage{{"plaza:1", "--show", "beauty"}, "wireframe, cage, picture, normals, level"},
        BadUsage{{"plaza:1", "--show", "normals,level"}, "at most one debug view"},
        BadUsage{{"plaza:1", "--show", "normals", "-o", "a.exr"}, "--show needs a .png"},
        BadUsage{{"plaza:1", "--subdivision-level", "9"}, "whole number from 1 to 8"},
        BadUsage{{"plaza:1", "--subdivision-edge", "0"}, "between 0 and"},
        BadUsage{{"plaza:1", "--subdivision-max-level", "0"}, "whole number from 1 to 8"},
        BadUsage{{"plaza:1", "--scatter-lights", "10,"}, "--scatter-lights"},
        BadUsage{{"plaza:1", "--frames", ""}, "frames such as"},
        BadUsage{{"plaza:1", "--frames", "3,,9"}, "frames such as"},
        BadUsage{{"plaza:1", "--frames", "5x2"}, "frames such as"},
        BadUsage{{"plaza:1", "--frames", "0-5x0"}, "whole number from 1"},
        BadUsage{{"plaza:1", "--frames", "5-4"}, "whole number from 5"},
        BadUsage{{"plaza:1", "--frames", "a-b"}, "whole number"},
        BadUsage{{"plaza:1", "--samples", "0"}, "whole number from 1 to 65536"},
        BadUsage{{"plaza:1", "--samples", "65537"}, "whole number from 1 to 65536"},
        BadUsage{{"plaza:1", "--aperture", "2.8"}, "--aperture needs --focus"},
        BadUsage{{"plaza:1", "--aperture", "0", "--focus", "2"}, "between 0 and 1000"},
        BadUsage{{"plaza:1", "--focus", "2"}, "--focus needs --aperture"},
        BadUsage{{"plaza:1", "--aperture", "2", "--focus", "0"}, "--focus"},
        BadUsage{{"plaza:1", "--blades", "6"}, "--blades needs --aperture"},
        BadUsage{{"plaza:1", "--aperture", "2", "--focus", "2", "--blades", "2"}, "3 to 64"},
        BadUsage{{"plaza:1", "--aperture", "2", "--focus", "2", "--ortho", "3"}, "exclude each other"},
        BadUsage{{"plaza:1", "--shutter", "1.5"}, "from 0 to 1"},
        BadUsage{{"plaza:1", "--fps", "0"}, "--fps"},
        BadUsage{{"plaza:1", "-o", "a.exr", "--aov-filter", "first"}, "needs --aov"},
        BadUsage{{"plaza:1", "-o", "a.exr", "--aov", "Z", "--aov-filter", "median"}, "average, first"},
        BadUsage{{"plaza:1", "--time", "noon"}, "expected a number"},
        BadUsage{{"plaza:1", "--device", "gpu"}, "software"},
        BadUsage{{"plaza:1", "--device", "-1"}, "software"},
        BadUsage{{"plaza:1", "--aov", "all"}, "needs an .exr"},
        BadUsage{{"plaza:1", "-o", "a.exr", "--aov", "Z,beauty"}, "\"beauty\""},
        BadUsage{{"plaza:1", "-o", "a.exr", "--aov", "Z,Z"}, "twice"},
        BadUsage{{"plaza:1", "-o", "a.exr", "--aov", ""}, "--aov"},
        BadUsage{{"plaza:1", "--ao-rays", "16"}, "--ao-rays needs --aov ambient_occlusion"},
        BadUsage{{"plaza:1", "-o", "a.exr", "--aov", "Z", "--ao-distance", "2"},
                 "--ao-distance needs --aov ambient_occlusion"},
        BadUsage{{"plaza:1", "-o", "a.exr", "--aov", "ambient_occlusion", "--ao-rays", "0"}, "1 to 4096"},
        BadUsage{{"plaza:1", "-o", "a.exr", "--aov", "ambient_occlusion", "--ao-rays", "4097"}, "1 to 4096"},
        BadUsage{{"plaza:1", "-o", "a.exr", "--aov", "ambient_occlusion", "--ao-distance", "0"},
                 "--ao-distance"},
        BadUsage{{"plaza:1", "--tiles", "gpu"}, "auto, cpu, compute"},
        BadUsage{{"plaza:1", "--environment", ""}, "FILE.hdr, FILE.exr, studio, sky or none"},
        BadUsage{{"plaza:1", "--environment", "picture.png"}, "FILE.hdr, FILE.exr, studio, sky or none"},
        BadUsage{{"plaza:1", "--environment", "none,90"}, "FILE.hdr, FILE.exr, studio, sky or none"},
        BadUsage{{"plaza:1", "--environment", "sky,"}, "FILE.hdr, FILE.exr, studio, sky or none"},
        BadUsage{{"plaza:1", "--environment", "sky,1,2,3"}, "FILE.hdr, FILE.exr, studio, sky or none"},
        BadUsage{{"plaza:1", "--environment", "sky,90,65"}, "between -64 and 64"},
        BadUsage{{"plaza:1", "--environment", "sky,nan"}, "between -1e"},
        BadUsage{{"plaza:1", "--background", "blue"}, "on, off"},
        BadUsage{{"plaza:1", "--shadows", "soft"}, "on, off"},
        BadUsage{{"plaza:1", "--shadows", "auto"}, "on, off"},
        BadUsage{{"plaza:1", "--specular-aa", "maybe"}, "on, off"},
        BadUsage{{"plaza:1", "--layers", "65"}, "whole number from 0 to 64"},
        BadUsage{{"plaza:1", "--threads", "--tiles", "many"}, "whole number from 0 to 1024"},
        BadUsage{{"plaza:1", "--threads", "1025"}, "whole number from 0 to 1024"},
        BadUsage{{"plaza:1", "--subdivision-evaluator", "gpu"}, "auto, cpu, compute"},
        BadUsage{{"plaza:1", "--png-level", "10"}, "whole number from 0 to 9"},
        BadUsage{{"plaza:1", "-o", "a.exr", "--png-level", "1"}, "--png-level needs a .png"},
        BadUsage{{"plaza:1", "-o", "a.exr", "--exr", "double"}, "float, half"},
        BadUsage{{"plaza:1", "--exr", "half"}, "--exr needs an .exr"},
        BadUsage{{"plaza:1", "-o", "a.exr", "--compression", "lzw"}, "zip, dwaa, piz, none"},
        BadUsage{{"plaza:1", "--compression", "zip"}, "--compression needs an .exr"},
        BadUsage{{"plaza:1", "--encode-threads", "1025"}, "whole number from 0 to 1024"},
        BadUsage{{"plaza:1", "--raw", "rgb"}, "rgba8"},
        BadUsage{{"plaza:1", "--format", "exr"}, "--format needs -o -"},
        BadUsage{{"plaza:1", "-o", "-", "--format", "exr", "--raw", "rgba8"}, "exclude each other"},
        BadUsage{{"plaza:1", "-o", "-", "--format", "exr", "--frames", "0-1"}, "takes one .exr"},
        BadUsage{{"plaza:1", "-o", "-", "--stats", "-"}, "exclude each other"},
        BadUsage{{"plaza:1", "-o", "-", "--skip-existing"}, "--skip-existing needs a file"},
        BadUsage{{"plaza:1", "--shard", "0/8"}, "whole number from 1 to 8"},
        BadUsage{{"plaza:1", "--shard", "9/8"}, "whole number from 1 to 8"},
        BadUsage{{"plaza:1", "--shard", "3"}, "such as 1/8 to 8/8"},
        BadUsage{{"plaza:1", "--turntable", "0"}, "whole number from 1"},
        BadUsage{{"plaza:1", "--progress", "xml"}, "terminal, json"},
        BadUsage{{"--list", "textures"}, "plugins, devices, displays, views"},
    };
    const TemporaryFolder folder;
    for (const BadUsage& mistake : mistakes) {
        SCOPED_TRACE(testing::PrintToString(mistake.arguments));
        expectUsageError(runCommand(mistake.arguments, {.folder = folder.path()}), mistake.reason);
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

TEST(Usage, HelpNamesEveryOptionOfTheContract) {
    const CommandResult result = runCommand({"--help"});
    expectSuccess(result);
    EXPECT_EQ(result.err, "");
    for (const char* option : {"SCENE",
                               "-o",
                               "--size",
                               "--camera",
                               "--eye",
                               "--target",
                               "--fov",
                               "--scatter-lights",
                               "--brdf",
                               "--technique",
                               "--ocio",
                               "--display",
                               "--view",
                               "--look",
                               "--exposure",
                               "--aov",
                               "--frames",
                               "--time",
                               "--stats",
                               "--plugin-path",
                               "--device",
                               "--strict",
                               "--quiet",
                               "--list",
                               "--threads",
                               "--subdivision-evaluator",
                               "--shadows",
                               "--ao-distance",
                               "--ao-rays",
                               "--samples",
                               "--aperture",
                               "--focus",
                               "--blades",
                               "--shutter",
                               "--fps",
                               "--aov-filter",
                               "--png-level",
                               "--exr",
                               "--compression",
                               "--shard",
                               "--turntable",
                               "--progress",
                               "environment_specular",
                               "Examples:",
                               "Exit codes:"})
        EXPECT_NE(result.out.find(option), std::string::npos) << option;
}

TEST(Usage, HelpFitsATerminal) {
    const std::string help = runCommand({"--help"}).out;
    for (std::size_t start = 0, end; (end = help.find('\n', start)) != help.npos; start = end + 1)
        EXPECT_LE(end - start, 110u) << help.substr(start, end - start);
}

TEST(Usage, VersionIsThatOfTheLibrary) {
    const CommandResult result = runCommand({"--version"});
    expectSuccess(result);
    EXPECT_EQ(result.out, "candela " CANDELA_VERSION "\n");
}

}  // namespace
