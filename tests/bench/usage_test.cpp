// Errors of the command line: exit code 2, one line.
#include "command.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <array>

namespace {

struct BadUsage {
    std::vector<std::string> arguments;
    std::string reason;
};

TEST(BenchUsage, EveryErrorIsNamed) {
    const std::array mistakes{
        BadUsage{{}, "--json is missing"},
        BadUsage{{"--json"}, "--json"},
        BadUsage{{"--json", "r.json", "--no-such-option"}, "--no-such-option"},
        BadUsage{{"--json", "r.json", "plaza", "rooms"}, "rooms"},
        BadUsage{{"--json", "r.json", "plaza", "--scene", "plaza"}, "exclude each other"},
        BadUsage{{"--json", "r.json", "plaza:100", "--lights", "64"}, "exclude each other"},
        BadUsage{{"--json", "r.json", "plaza:many"}, "whole number from 0 to 16000000"},
        BadUsage{{"--json", "r.json", "--lights", "many"}, "whole number from 0 to 16000000"},
        BadUsage{{"--json", "r.json", "--lights", "64,"}, "whole number"},
        BadUsage{{"--json", "r.json", "--lights", "-1"}, "whole number"},
        BadUsage{{"--json", "r.json", "--lights", "16000001"}, "whole number"},
        BadUsage{{"--json", "r.json", "--technique", "magic"}, "auto, volumes, tiles, fullscreen"},
        BadUsage{{"--json", "r.json", "--technique", "volumes,"}, "--technique"},
        BadUsage{{"--json", "r.json", "--technique", "tiles,tiles"}, "twice"},
        BadUsage{{"--json", "r.json", "--shadows", "auto"}, "on, off"},
        BadUsage{{"--json", "r.json", "--shadows", "off,"}, "--shadows"},
        BadUsage{{"--json", "r.json", "--shadows", "off,off"}, "twice"},
        BadUsage{{"--json", "r.json", "--brdf", "phong"}, "course, gltf"},
        BadUsage{{"--json", "r.json", "--baseline", "--brdf", "gltf"}, "course"},
        BadUsage{{"--json", "r.json", "--environment", "cave"}, "studio, sky or none"},
        BadUsage{{"--json", "r.json", "--baseline", "--environment", "sky"}, "--environment"},
        BadUsage{{"--json", "r.json", "--scene", "cages", "--environment", "sky"}, "--environment"},
        BadUsage{{"--json", "r.json", "--size", "640"}, "WIDTHxHEIGHT"},
        BadUsage{{"--json", "r.json", "--size", "0x5"}, "whole number from 1 to 65536"},
        BadUsage{{"--json", "r.json", "--frames", "0"}, "whole number from 1"},
        BadUsage{{"--json", "r.json", "--device", "gpu"}, "software"},
        BadUsage{{"--json", "r.json", "--tiles", "gpu"}, "auto, cpu, compute"},
        BadUsage{{"--json", "r.json", "--threads", "--tiles", "-1"}, "whole number from 0 to 1024"},
        BadUsage{{"--json", "r.json", "--subdivision-evaluator", "gpu"}, "auto, cpu, compute"},
        BadUsage{{"--json", "r.json", "--tiles", "cpu,cpu"}, "twice"},
        BadUsage{{"--json", "r.json", "--scene", "cages", "--ceiling"}, "--ceiling"},
        BadUsage{{"--json", "r.json", "--scene", ""}, "--scene"},
        BadUsage{{"--json", "r.json", "--scene", "triangles:9,4"}, "--lights"},
    };
    const TemporaryFolder folder;
    for (const BadUsage& mistake : mistakes) {
        SCOPED_TRACE(mistake.reason);
        expectUsageError(runCommand(mistake.arguments, {.folder = folder.path()}), mistake.reason);
    }
    EXPECT_TRUE(folder.names().empty());
}

TEST(BenchUsage, HelpNamesEveryOption) {
    const CommandResult result = runCommand({"--help"});
    expectSuccess(result);
    for (const char* option : {"--scene",   "--lights",      "--technique",   "--size",
                               "--frames",  "--json",        "--plot",        "--baseline",
                               "--device",  "--environment", "--plugin-path", "--brdf",
                               "--view",    "--quiet",       "--threads",     "--subdivision-evaluator",
                               "--shadows", "--ceiling",     "--markdown",    "--version"})
        EXPECT_NE(result.out.find(option), std::string::npos) << option;
}

TEST(BenchUsage, VersionIsThatOfTheLibrary) {
    const CommandResult result = runCommand({"--version"});
    expectSuccess(result);
    EXPECT_EQ(result.out, "candela " CANDELA_VERSION "\n");
}

}  // namespace
