// The keys and values of the JSON results.
#include "bench_run.h"

#include "command.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

namespace {

using Names = std::vector<std::string>;

const Names contractKeys{"scene",      "lights",    "technique",      "width",
                         "height",     "frame_ms",  "geometry_ms",    "lighting_ms",
                         "display_ms", "pairs_lit", "pairs_evaluated"};

void expectContract(const Json& result) {
    const Names keys = keysOf(result);
    ASSERT_GE(keys.size(), contractKeys.size());
    EXPECT_EQ(Names(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(contractKeys.size())),
              contractKeys);
    EXPECT_TRUE(result["scene"].is_string());
    EXPECT_TRUE(result["technique"].is_string());
    for (const char* key : {"lights", "width", "height", "pairs_lit", "pairs_evaluated"})
        EXPECT_TRUE(result[key].is_number_unsigned()) << key;
    for (const char* key : {"frame_ms", "geometry_ms", "lighting_ms", "display_ms"}) {
        ASSERT_TRUE(result[key].is_number()) << key;
        EXPECT_GE(result[key].get<double>(), 0.0) << key;
    }
    EXPECT_GT(result["frame_ms"].get<double>(), 0.0);
}

TEST(BenchResults, KeysAreTheDocumentedOnes) {
    const Json bench = benchOf({"--lights", "16,64", "--technique", "all", "--baseline"});
    EXPECT_EQ(keysOf(bench), (Names{"renderer", "setup", "results"}));
    EXPECT_FALSE(bench["renderer"].get<std::string>().empty());
    EXPECT_EQ(keysOf(bench["setup"]),
              (Names{"version", "cpu", "cores", "threads", "system", "opengl", "brdf", "view"}));
    EXPECT_EQ(bench["setup"]["version"], CANDELA_VERSION);
    for (const Json& result : bench["results"]) expectContract(result);
}

TEST(BenchResults, ARowForEachNumberOfLightsAndTechnique) {
    const Json bench = benchOf({"--lights", "16,64", "--technique", "volumes,tiles"});
    std::vector<std::pair<int, std::string>> rows;
    for (const Json& result : bench["results"]) rows.emplace_back(result["lights"], result["technique"]);
    EXPECT_EQ(rows, (std::vector<std::pair<int, std::string>>{
                        {16, "volumes"}, {16, "tiles"}, {64, "volumes"}, {64, "tiles"}}));
}

TEST(BenchResults, ValuesMatchTheRun) {
    const Json bench = benchOf({"--lights", "64", "--technique", "volumes,tiles,fullscreen"});
    const Json volumes = resultsOf(bench, "volumes").at(0), fullscreen = resultsOf(bench, "fullscreen").at(0),
               tiles = resultsOf(bench, "tiles").at(0);
    for (const Json& result : {volumes, tiles, fullscreen}) {
        EXPECT_EQ(result["scene"], "plaza");
        EXPECT_EQ(result["width"], 160);
        EXPECT_EQ(result["height"], 90);
        EXPECT_EQ(result["frames"], 2);
        EXPECT_EQ(result["lights_dropped"], 0);
        // Which pairs are lit does not depend on the technique.
        EXPECT_EQ(result["pairs_lit"], volumes["pairs_lit"]);
        EXPECT_GT(result["pairs_lit"].get<int>(), 0);
        EXPECT_GE(result["pairs_evaluated"].get<int>(), result["pairs_lit"].get<int>());
        EXPECT_LE(result["lights_visible"].get<int>(), 64);
    }
    EXPECT_LT(tiles["pairs_evaluated"].get<int>(), fullscreen["pairs_evaluated"].get<int>());
}

TEST(BenchResults, NamesTheThreadsUsed) {
    EXPECT_EQ(benchOf({"--lights", "4", "--threads", "3"})["setup"]["threads"], 3);
}

TEST(BenchResults, NamesTheTileBackendUsed) {
    const Json bench = benchOf({"--lights", "4", "--technique", "volumes,tiles", "--tiles", "compute"});
    EXPECT_EQ(resultsOf(bench, "tiles").at(0)["tile_backend"], "compute");
    EXPECT_FALSE(resultsOf(bench, "volumes").at(0).contains("tile_backend"));
}

TEST(BenchResults, AutoNamesTheTechniqueUsed) {
    const Json bench = benchOf({"--lights", "16"});
    ASSERT_EQ(bench["results"].size(), 1u);
    EXPECT_NE(bench["results"][0]["technique"], "auto");
}

TEST(BenchResults, TheBaselineIsOfTheSameScene) {
    const Json bench =
        benchOf({"--lights", "64", "--technique", "volumes", "--baseline", "--shadows", "off"});
    ASSERT_EQ(bench["results"].size(), 4u);
    const Json volumes = bench["results"][0];
    for (const char* name : {"textbook_volumes", "textbook_fullscreen"}) {
        const Json textbook = resultsOf(bench, name).at(0);
        EXPECT_EQ(textbook["lights"], 64);
        EXPECT_EQ(textbook["pairs_lit"], volumes["pairs_lit"]) << name;
        EXPECT_GT(textbook["lighting_ms"].get<double>(), 0.0) << name;
        // Everything is evaluated that is lit, but for a pixel in a thousand at edges: half floats and a
        // depth of 24 bits move a few across.
        EXPECT_GT(textbook["pairs_evaluated"].get<double>(), 0.999 * volumes["pairs_lit"].get<double>())
            << name;
    }
    const Json bare = resultsOf(bench, "bare").at(0);
    EXPECT_EQ(bare["lighting_ms"], 0.0);
    EXPECT_EQ(bare["pairs_evaluated"], 0);
}

/// The sample scene with a light so strong that half floats overflow.
std::string overflowingScene() {
    std::string scene = sampleScene();
    const std::string weak = "\"intensity\":10,";
    scene.replace(scene.find(weak), weak.size(), "\"intensity\":1e8,");
    return scene;
}

TEST(BenchResults, ABaselineThatCannotDrawTheSceneIsAnErrorAndOtherResultsAreKept) {
    const TemporaryFolder folder;
    folder.write("bright.gltf", overflowingScene());
    const Json bench = benchOf(
        {"--scene", folder / "bright.gltf", "--technique", "volumes", "--baseline", "--shadows", "off"});
    ASSERT_EQ(bench["results"].size(), 4u);
    EXPECT_GT(bench["results"][0]["frame_ms"].get<double>(), 0.0);
    for (const char* name : {"textbook_volumes", "textbook_fullscreen"}) {
        const Json textbook = resultsOf(bench, name).at(0);
        EXPECT_EQ(keysOf(textbook), (Names{"scene", "lights", "technique", "width", "height", "error"}));
        // Drivers differ: values beyond half floats become infinite, or are clamped and differ.
        EXPECT_NE(textbook["error"].get<std::string>().find("its picture"), std::string::npos) << textbook;
    }
    EXPECT_GT(resultsOf(bench, "bare").at(0)["frame_ms"].get<double>(), 0.0);
}

TEST(BenchResults, ABaselineThatDoesNotSupportTheSceneIsAnErrorToo) {
    const TemporaryFolder folder;
    std::string scene = sampleScene();
    const std::string range = ",\"range\":20";
    scene.erase(scene.find(range), range.size());
    folder.write("no_range.gltf", scene);
    const CommandResult run = runCommand({"--scene", "no_range.gltf", "--technique", "volumes", "--baseline",
                                          "--size", "32x18", "--frames", "1", "--json", "r.json"},
                                         {.folder = folder.path()});
    expectSuccess(run);
    EXPECT_NE(run.out.find("textbook_volumes, 1 lights: not measured: "), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("point lights with a range only"), std::string::npos) << run.out;
}

// In either scene of lights that reach no surface.
TEST(BenchResults, LightsOutOfRangeAreNotCountedAsLit) {
    const Json outside =
        benchOf({"--scene", "outside", "--lights", "64", "--technique", "volumes"})["results"][0];
    EXPECT_EQ(outside["lights"], 64);
    EXPECT_EQ(outside["lights_visible"], 0);
    EXPECT_EQ(outside["pairs_lit"], 0);
    EXPECT_EQ(outside["reference_lights"], 0);
    EXPECT_GE(outside["reference_lighting_ms"].get<double>(), 0.0);
    EXPECT_GT(outside["copy_ms"].get<double>(), 0.0);

    const Json plaza = benchOf({"--lights", "64", "--technique", "volumes"})["results"][0];
    const Json hidden =
        benchOf({"--scene", "hidden", "--lights", "64", "--technique", "volumes"})["results"][0];
    EXPECT_EQ(hidden["lights"], 128) << "twice as many";
    EXPECT_EQ(hidden["pairs_lit"], plaza["pairs_lit"]);
    EXPECT_EQ(hidden["reference_lights"], 64);
    EXPECT_GT(hidden["reference_lighting_ms"].get<double>(), 0.0);
}

// In the variant the square is unlit, so that no light reaches a pixel.
TEST(BenchResults, OfAVariant) {
    Json scene = Json::parse(sampleScene());
    scene["materials"].push_back({{"extensions", {{"KHR_materials_unlit", Json::object()}}}});
    scene["extensions"]["KHR_materials_variants"]["variants"].push_back({{"name", "Flat"}});
    scene["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"].push_back(
        {{"material", 1}, {"variants", Json::array({0})}});
    const TemporaryFolder folder;
    folder.write("looks.gltf", scene.dump());
    const auto litPairs = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(),
                         {"--scene", folder / "looks.gltf", "--technique", "volumes", "--shadows", "off"});
        return benchOf(arguments)["results"].at(0)["pairs_lit"].get<std::uint64_t>();
    };
    EXPECT_GT(litPairs({}), 0u);
    EXPECT_EQ(litPairs({"--variant", "Flat"}), 0u);
    EXPECT_EQ(litPairs({"--variant", "0"}), 0u);
    expectFault(
        runCommand({"--scene", folder / "looks.gltf", "--variant", "Red", "--json", folder / "r.json"}),
        folder / "looks.gltf", "no variant \"Red\"; there are 0 \"Flat\"");
}

TEST(BenchResults, GoToStandardOutput) {
    const CommandResult result = runCommand({"plaza:16", "--size", "64x36", "--frames", "1", "--json", "-"},
                                            {.folder = TemporaryFolder().path()});
    expectSuccess(result);
    const Json bench = Json::parse(result.out);
    ASSERT_EQ(bench["results"].size(), 1u);
    EXPECT_EQ(bench["results"][0]["scene"], "plaza");
    EXPECT_EQ(bench["results"][0]["lights"], 16);
    EXPECT_NE(result.err.find("plaza"), std::string::npos) << "the table";
}

TEST(BenchResults, CsvHasARowForEach) {
    const TemporaryFolder folder;
    expectSuccess(runCommand({"rooms:16", "--size", "64x36", "--frames", "1", "--technique", "tiles,volumes",
                              "--quiet", "--json", "r.csv"},
                             {.folder = folder.path()}));
    std::ifstream stream(folder / "r.csv");
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_TRUE(lines[0].starts_with("renderer,scene,lights,technique,")) << lines[0];
    // The name of the renderer has commas of its own.
    for (const auto& [row, technique] : {std::pair{1, "tiles"}, {2, "volumes"}}) {
        EXPECT_NE(lines[row].find(std::string(",rooms,16,") + technique + ","), std::string::npos)
            << lines[row];
        EXPECT_EQ(lines[row].back(), '\r');
    }
}

}  // namespace
