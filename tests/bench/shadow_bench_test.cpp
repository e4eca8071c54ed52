// --shadows: rows with shadows and without, and cube shadow maps as their baseline.
#include "bench_run.h"

#include "command.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace {

using Names = std::vector<std::string>;

TEST(BenchShadows, ARowWithoutThemHasNoRays) {
    const Json row = benchOf({"--lights", "16", "--shadows", "off"})["results"].at(0);
    EXPECT_EQ(row["shadows"], "off");
    for (const char* key : {"occlusion", "shadow_cost", "shadow_maps"})
        EXPECT_FALSE(row.contains(key)) << key;
}

TEST(BenchShadows, TheBaselineDrawsNoMapsWithoutThem) {
    const Json bench = benchOf({"--lights", "16", "--shadows", "off", "--baseline"});
    EXPECT_TRUE(resultsOf(bench, "cube_shadow_maps").empty());
}

#ifdef CANDELA_SHADOWS

TEST(BenchShadows, RowsAreInTheGivenOrderOfTechniqueAndShadows) {
    const Json bench = benchOf({"--lights", "16,32", "--technique", "volumes,tiles", "--shadows", "on,off"});
    std::vector<std::string> rows;
    for (const Json& row : bench["results"])
        rows.push_back(row["lights"].dump() + " " + row["technique"].get<std::string>() + " " +
                       row["shadows"].get<std::string>());
    EXPECT_EQ(rows, (Names{"16 volumes on", "16 volumes off", "16 tiles on", "16 tiles off", "32 volumes on",
                           "32 volumes off", "32 tiles on", "32 tiles off"}));
}

TEST(BenchShadows, ARowWithThemHasRaysAndStructure) {
    const Json bench = benchOf({"--lights", "64", "--shadows", "on,off"});
    const Json &on = bench["results"].at(0), &off = bench["results"].at(1);
    EXPECT_EQ(on["shadows"], "on");
    EXPECT_EQ(off["shadows"], "off");
    EXPECT_EQ(on["frames"], off["frames"]) << "drawn alternately";
    const Json& occlusion = on["occlusion"];
    EXPECT_EQ(keysOf(occlusion), (Names{"rays_asked", "rays_traced", "rays_saved", "triangles", "instances",
                                        "bytes", "build_ms", "update_ms"}));
    EXPECT_GT(occlusion["rays_asked"].get<int>(), 0);
    EXPECT_EQ(occlusion["instances"], 257) << "the ground and 256 spheres";
    EXPECT_LE(occlusion["rays_asked"], on["pairs_lit"]) << "a lit pair is one ray at most";
    EXPECT_EQ(occlusion["rays_traced"].get<int>() + occlusion["rays_saved"].get<int>(),
              occlusion["rays_asked"]);
}

TEST(BenchShadows, TheirCostIsThatAgainstTheRowWithout) {
    const Json bench = benchOf({"--lights", "64", "--shadows", "on,off"});
    const Json &on = bench["results"].at(0), &off = bench["results"].at(1);
    EXPECT_FALSE(off.contains("shadow_cost"));
    const auto ratio = [&](const char* key) { return on[key].get<double>() / off[key].get<double>(); };
    const Json& cost = on["shadow_cost"];
    EXPECT_DOUBLE_EQ(cost["frame_ratio"], ratio("frame_ms"));
    EXPECT_DOUBLE_EQ(cost["lighting_ratio"], ratio("lighting_ms"));
    EXPECT_FALSE(cost.contains("shadow_map_ratio")) << "without --baseline";
    const double more = on["frame_ms"].get<double>() - off["frame_ms"].get<double>();
    if (more > 0.0)
        EXPECT_DOUBLE_EQ(cost["ms_per_light"], more / on["lights_visible"].get<double>());
    else
        EXPECT_FALSE(cost.contains("ms_per_light")) << "noise";
}

TEST(BenchShadows, AloneTheyHaveNoCost) {
    const Json row = benchOf({"--lights", "16", "--shadows", "on"})["results"].at(0);
    EXPECT_EQ(row["shadows"], "on");
    EXPECT_FALSE(row.contains("shadow_cost"));
}

TEST(BenchShadows, TheBaselineDrawsAMapForEachLightInView) {
    const Json bench =
        benchOf({"--lights", "64", "--technique", "tiles", "--shadows", "on,off", "--baseline"});
    const Json on = bench["results"].at(0), maps = resultsOf(bench, "cube_shadow_maps").at(0);
    EXPECT_EQ(maps["lights"], 64);
    EXPECT_GT(maps["frame_ms"].get<double>(), 0.0);
    EXPECT_EQ(maps["lighting_ms"], 0.0);
    EXPECT_FALSE(maps.contains("shadows"));
    EXPECT_EQ(keysOf(maps["shadow_maps"]), (Names{"lights", "ms_per_light", "triangles_per_light"}));
    EXPECT_EQ(maps["shadow_maps"]["lights"], maps["lights_visible"]);
    EXPECT_GT(maps["lights_visible"].get<int>(), 0);
    EXPECT_LE(maps["lights_visible"].get<int>(), 64);
    EXPECT_DOUBLE_EQ(maps["shadow_maps"]["ms_per_light"],
                     maps["frame_ms"].get<double>() / maps["lights_visible"].get<double>());
    // Lights of the plaza hang over the ground, of 8192 triangles, which five faces of a cube see at most.
    // The scene has 256 spheres of about 900 besides: those out of range are not drawn.
    EXPECT_GE(maps["shadow_maps"]["triangles_per_light"].get<int>(), 8192);
    EXPECT_LE(maps["shadow_maps"]["triangles_per_light"].get<int>(), 5 * 8192 + 16 * 900);
    if (!on["shadow_cost"].contains("ms_per_light")) return;  // noise
    EXPECT_DOUBLE_EQ(
        on["shadow_cost"]["shadow_map_ratio"],
        maps["shadow_maps"]["ms_per_light"].get<double>() / on["shadow_cost"]["ms_per_light"].get<double>());
}

TEST(BenchShadows, MapsOfOtherLightsAreAnErrorInTheirRow) {
    const TemporaryFolder folder;
    std::string scene = sampleScene();
    const std::string range = ",\"range\":20";
    scene.erase(scene.find(range), range.size());
    folder.write("no_range.gltf", scene);
    const Json bench = benchOf(
        {"--scene", folder / "no_range.gltf", "--technique", "volumes", "--shadows", "on", "--baseline"});
    const Json maps = resultsOf(bench, "cube_shadow_maps").at(0);
    EXPECT_NE(maps["error"].get<std::string>().find("point lights with a range only"), std::string::npos)
        << maps;
    EXPECT_EQ(bench["results"][0]["shadows"], "on");
}

TEST(BenchShadows, ThereIsNoMapWithoutALightInView) {
    const Json bench = benchOf(
        {"--scene", "outside", "--lights", "16", "--technique", "tiles", "--shadows", "on", "--baseline"});
    EXPECT_NE(resultsOf(bench, "cube_shadow_maps").at(0)["error"].get<std::string>().find("no light in view"),
              std::string::npos);
    EXPECT_EQ(bench["results"][0]["reference_lights"], 0);
}

TEST(BenchShadows, TheTableAndThePlotTellThemApart) {
    const TemporaryFolder folder;
    const CommandResult run =
        runCommand({"--lights", "16,32", "--technique", "tiles", "--shadows", "on,off", "--size", "64x36",
                    "--frames", "1", "--json", "r.json", "--plot", "r.svg", "--baseline"},
                   {.folder = folder.path()});
    expectSuccess(run);
    for (const char* text : {"tiles, shadows, 16 lights: ", "M rays asked", "times what it takes without",
                             "cube_shadow_maps, 16 lights: "})
        EXPECT_NE(run.out.find(text), run.out.npos) << text << "\n" << run.out;
    std::ifstream stream(folder / "r.svg");
    const std::string svg{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_NE(svg.find(">tiles</text>"), svg.npos);
    EXPECT_NE(svg.find(">tiles, shadows</text>"), svg.npos);
}

#else

TEST(BenchShadows, AreAnErrorWhereTheLibraryHasNone) {
    const TemporaryFolder folder;
    expectFault(runCommand({"--json", "r.json", "--shadows", "on,off"}, {.folder = folder.path()}),
                "--shadows on", "CANDELA_SHADOWS");
    EXPECT_TRUE(folder.names().empty());
}

#endif

}  // namespace
