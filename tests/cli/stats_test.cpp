// --stats: the keys and values of its JSON.

#include "command.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

Names keys(const Json& object) {
    Names names;
    for (const auto& item : object.items()) names.push_back(item.key());
    return names;
}

Json statsOf(std::vector<std::string> arguments) {
    const TemporaryFolder folder;
    folder.write("square.gltf", sampleScene());
    arguments.insert(arguments.begin() + 1, {"--samples", "1"});
    arguments.insert(arguments.end(), {"--stats", "-", "--quiet"});
    const CommandResult result = runCommand(arguments, {.folder = folder.path()});
    expectSuccess(result);
    return Json::parse(result.out);
}

TEST(Stats, KeysAreTheDocumentedOnes) {
    const Json stats = statsOf({"plaza:16", "--size", "64x36"});
    EXPECT_EQ(keys(stats), (Names{"version",
                                  "renderer",
                                  "width",
                                  "height",
                                  "technique",
                                  "brdf",
                                  "scene",
                                  "passes",
                                  "frame_ms",
                                  "counters",
                                  "threads",
                                  "tile_backend",
                                  "subdivision_evaluator",
                                  "shadows",
                                  "environment",
                                  "samples",
                                  "notes",
                                  "file",
                                  "driver",
                                  "device",
                                  "pictures"}));
    EXPECT_EQ(keys(stats["scene"]),
              (Names{"triangles", "materials", "lights", "meshes", "cages", "nodes", "images", "cameras",
                     "animations", "variants", "material_kinds", "lines", "points"}));
    EXPECT_EQ(keys(stats["frame_ms"]), (Names{"median", "min", "max", "count"}));
    EXPECT_EQ(keys(stats["counters"]),
              (Names{"lights", "lights_visible", "pairs_lit", "pairs_evaluated", "lights_dropped"}));
    ASSERT_FALSE(stats["passes"].empty());
    for (const Json& pass : stats["passes"]) {
        EXPECT_EQ(keys(pass), (Names{"name", "ms"}));
        EXPECT_FALSE(pass["name"].get<std::string>().empty());
        EXPECT_GE(pass["ms"].get<double>(), 0.0);
    }
}

TEST(Stats, ShadowsAreNullWithoutThem) {
    EXPECT_TRUE(statsOf({"plaza:16", "--size", "64x36", "--shadows", "off"})["shadows"].is_null());
}

#ifdef CANDELA_SHADOWS
TEST(Stats, ShadowsAreNullInADebugView) {
    const Json stats = statsOf({"plaza:16", "--size", "64x36", "--shadows", "on", "--show", "normals"});
    EXPECT_TRUE(stats["shadows"].is_null());
}

TEST(Stats, ShadowsHaveRaysAndStructure) {
    const Json stats = statsOf({"plaza:16", "--size", "64x36", "--shadows", "on"});
    const Json& shadows = stats["shadows"];
    EXPECT_EQ(keys(shadows), (Names{"rays_asked", "rays_traced", "rays_saved", "triangles", "instances",
                                    "bytes", "build_ms", "update_ms"}));
    for (const char* key : {"rays_asked", "rays_traced", "rays_saved", "triangles", "instances", "bytes"})
        EXPECT_TRUE(shadows[key].is_number_unsigned()) << key;
    // A lit pair is one ray at most.
    EXPECT_GT(shadows["rays_asked"].get<int>(), 0);
    EXPECT_LE(shadows["rays_asked"], stats["counters"]["pairs_lit"]);
    EXPECT_EQ(shadows["rays_traced"].get<int>() + shadows["rays_saved"].get<int>(), shadows["rays_asked"]);
    EXPECT_GT(shadows["triangles"].get<int>(), 200'000);
    EXPECT_EQ(shadows["instances"], 257) << "the ground and 256 spheres";
    EXPECT_GT(shadows["bytes"], shadows["triangles"]);
    EXPECT_GE(shadows["build_ms"].get<double>(), 0.0);
    EXPECT_GE(shadows["update_ms"].get<double>(), 0.0);
}
#else
TEST(Stats, ShadowsAreAnErrorWhereTheLibraryHasNone) {
    const TemporaryFolder folder;
    expectFault(runCommand({"plaza:16", "--shadows", "on"}, {.folder = folder.path()}), "--shadows on",
                "CANDELA_SHADOWS");
    EXPECT_TRUE(folder.names().empty());
}
#endif

TEST(Stats, TileBackendIsTheOneThatRan) {
    for (const char* backend : {"cpu", "compute"}) {
        const Json stats = statsOf({"plaza:16", "--size", "64x36", "--tiles", backend});
        EXPECT_EQ(stats["tile_backend"], backend);
    }
}

TEST(Stats, ValuesMatchTheFrame) {
    const Json stats = statsOf({"plaza:16", "--size", "64x36", "--technique", "volumes", "--brdf", "gltf"});
    EXPECT_EQ(stats["version"], CANDELA_VERSION);
    EXPECT_FALSE(stats["renderer"].get<std::string>().empty());
    EXPECT_EQ(stats["file"], "plaza:16");
    EXPECT_NE(stats["driver"].get<std::string>().find("4."), std::string::npos) << stats["driver"];
    EXPECT_FALSE(stats["device"].get<std::string>().empty());
    EXPECT_EQ(stats["width"], 64);
    EXPECT_EQ(stats["height"], 36);
    EXPECT_EQ(stats["technique"], "volumes");
    EXPECT_EQ(stats["brdf"], "gltf");
    EXPECT_EQ(stats["tile_backend"], "") << "not tiles";
    EXPECT_EQ(stats["subdivision_evaluator"], "") << "no cages";
    EXPECT_EQ(stats["scene"]["lights"], 16);
    EXPECT_EQ(stats["counters"]["lights"], 16);
    EXPECT_EQ(stats["counters"]["lights_dropped"], 0);
    // The ground's 64 × 64 quads are 8192 triangles; 256 spheres of about 900 are added.
    EXPECT_GT(stats["scene"]["triangles"].get<int>(), 200'000);
    EXPECT_GE(stats["scene"]["materials"].get<int>(), 256);
}

TEST(Stats, NamesTheThreadsUsed) {
    EXPECT_EQ(statsOf({"square.gltf", "--size", "16x16", "--threads", "3"})["threads"], 3);
    EXPECT_GE(statsOf({"square.gltf", "--size", "16x16"})["threads"], 1);
}

TEST(Stats, AutoNamesTheTechniqueUsed) {
    EXPECT_NE(statsOf({"square.gltf", "--size", "16x16"})["technique"], "auto");
}

TEST(Stats, ASingleFrameIsDrawnFiveTimes) {
    const Json times = statsOf({"square.gltf", "--size", "16x16"})["frame_ms"];
    EXPECT_EQ(times["count"], 5);
    EXPECT_GT(times["min"].get<double>(), 0.0);
    EXPECT_LE(times["min"].get<double>(), times["median"].get<double>());
    EXPECT_LE(times["median"].get<double>(), times["max"].get<double>());
}

TEST(Stats, EveryFrameOfARangeCounts) {
    EXPECT_EQ(statsOf({"square.gltf", "--size", "16x16", "--frames", "0-2"})["frame_ms"]["count"], 3);
}

TEST(Stats, PairsAreCounted) {
    // The square covers a middle of 32/3 pixels a side, all within the light's range.
    const Json counters =
        statsOf({"square.gltf", "--size", "32x32", "--technique", "fullscreen"})["counters"];
    EXPECT_EQ(counters["lights_visible"], 1);
    EXPECT_GE(counters["pairs_lit"].get<int>(), 10 * 10);
    EXPECT_LE(counters["pairs_lit"].get<int>(), 12 * 12);
    EXPECT_GE(counters["pairs_evaluated"].get<int>(), counters["pairs_lit"].get<int>());
}

TEST(Stats, ScatteredLightsCount) {
    EXPECT_EQ(statsOf({"square.gltf", "--size", "16x16", "--scatter-lights", "63"})["scene"]["lights"], 64);
}

TEST(Stats, FileAndStandardOutputHaveTheSameKeys) {
    const TemporaryFolder folder;
    expectSuccess(
        runCommand({"plaza:1", "--size", "16x16", "--stats", "stats.json"}, {.folder = folder.path()}));
    EXPECT_EQ(folder.names(), (Names{"candela.png", "stats.json"}));
    std::ifstream file(folder / "stats.json");
    EXPECT_EQ(keys(Json::parse(file)), keys(statsOf({"plaza:1", "--size", "16x16"})));
}

}  // namespace
