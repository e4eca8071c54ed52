#include "results.h"

#include "bench_scene.h"
#include "common/scene_environment.h"
#include "markdown_table.h"
#include "result_text.h"

#include <candela/threads.h>
#include <candela/version.h>

#include <epoxy/gl.h>
#include <sys/utsname.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace {

using Json = nlohmann::ordered_json;

/// The processor's name in /proc/cpuinfo; empty where there is none.
std::string cpuName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != line.npos) return line.substr(colon + 2);
    }
    return "";
}

std::string systemName() {
    utsname names{};
    if (uname(&names) != 0) return "";
    return std::string(names.sysname) + " " + names.release + " " + names.machine;
}

template <typename Value>
void put(Json& row, const char* name, const std::optional<Value>& value) {
    if (value) row[name] = *value;
}

Json failedRow(const Result& result) {
    Json row{{"scene", result.scene},
             {"lights", result.lights},
             {"technique", result.technique},
             {"width", result.width},
             {"height", result.height}};
    if (result.shadows) row["shadows"] = candela::toString(*result.shadows);
    if (result.samples > 1) row["samples"] = result.samples;
    row["error"] = *result.error;
    return row;
}

/// What shadows cost: a row with them against the row of the same technique without.
struct ShadowCost {
    double frameRatio = 0.0, lightingRatio = 0.0;
    std::optional<double> millisecondsPerLight;  ///< Of a light in view; more than 0.
    std::optional<double> shadowMapRatio;        ///< How many times as long a cube shadow map takes.
};

bool isOfSameLights(const Result& a, const Result& b) {
    return a.scene == b.scene && a.lights == b.lights;
}

/// What a picture of many samples takes, in frames of one sample, display and read-back included in both;
/// none where that was not measured.
std::optional<double> singleFrames(const Result& many, const std::vector<Result>& results) {
    if (many.error || many.samples == 1) return std::nullopt;
    const auto one = std::ranges::find_if(results, [&](const Result& other) {
        return !other.error && other.samples == 1 && isOfSameLights(other, many) &&
               other.technique == many.technique && other.tileBackend == many.tileBackend &&
               other.shadows == many.shadows;
    });
    if (one == results.end() || one->picture.value_or(0.0) <= 0.0 || !many.picture) return std::nullopt;
    return *many.picture / *one->picture;
}

/// None for other rows, and where the row without shadows was not measured.
std::optional<ShadowCost> shadowCost(const Result& on, const std::vector<Result>& results) {
    if (on.error || on.shadows != candela::Shadows::on) return std::nullopt;
    const auto off = std::ranges::find_if(results, [&](const Result& other) {
        return !other.error && other.shadows == candela::Shadows::off && isOfSameLights(other, on) &&
               other.technique == on.technique && other.tileBackend == on.tileBackend &&
               other.samples == on.samples;
    });
    if (off == results.end() || off->frame <= 0.0 || off->lighting.value_or(0.0) <= 0.0) return std::nullopt;
    ShadowCost cost{on.frame / off->frame, *on.lighting / *off->lighting, {}, {}};
    const double more = on.frame - off->frame;
    if (more <= 0.0 || on.lightsVisible.value_or(0) == 0) return cost;
    cost.millisecondsPerLight = more / static_cast<double>(*on.lightsVisible);
    const auto maps = std::ranges::find_if(results, [&](const Result& other) {
        return !other.error && other.shadowMaps && isOfSameLights(other, on);
    });
    if (maps != results.end())
        cost.shadowMapRatio = maps->shadowMaps->millisecondsPerLight() / *cost.millisecondsPerLight;
    return cost;
}

Json costJson(const ShadowCost& cost) {
    Json json{{"frame_ratio", cost.frameRatio}, {"lighting_ratio", cost.lightingRatio}};
    put(json, "ms_per_light", cost.millisecondsPerLight);
    put(json, "shadow_map_ratio", cost.shadowMapRatio);
    return json;
}

Json shadowMapsJson(const ShadowMaps& maps) {
    return {{"lights", maps.lights},
            {"ms_per_light", maps.millisecondsPerLight()},
            {"triangles_per_light", maps.triangles / maps.lights}};
}

Json ceilingJson(const Ceiling& ceiling) {
    if (ceiling.error) return {{"error", *ceiling.error}};
    return {{"pairs_per_second", ceiling.pairsPerSecond}};
}

// The first eleven keys are a contract: other programs read them.
Json rowOf(const Result& result, const std::vector<Result>& results, const std::optional<Ceiling>& ceiling) {
    if (result.error) return failedRow(result);
    Json row{{"scene", result.scene},
             {"lights", result.lights},
             {"technique", result.technique},
             {"width", result.width},
             {"height", result.height},
             {"frame_ms", result.frame},
             {"geometry_ms", result.geometry.value_or(0.0)},
             {"lighting_ms", result.lighting.value_or(0.0)},
             {"display_ms", result.display.value_or(0.0)},
             {"pairs_lit", result.pairsLit.value_or(0)},
             {"pairs_evaluated", result.pairsEvaluated.value_or(0)},
             {"frames", result.frames}};
    put(row, "tile_backend", result.tileBackend);
    put(row, "ambient_occlusion_ms", result.ambientOcclusion);
    put(row, "environment_ms", result.environment);
    put(row, "background_ms", result.background);
    put(row, "lights_visible", result.lightsVisible);
    put(row, "lights_dropped", result.lightsDropped);
    put(row, "light_list_bytes", result.lightListBytes);
    put(row, "triangles", result.triangles);
    put(row, "picture_ms", result.picture);
    put(row, "set_lights_ms", result.setLights);
    if (result.reference) {
        row["reference_lights"] = result.reference->lights;
        row["reference_lighting_ms"] = result.reference->lighting;
    }
    put(row, "copy_ms", result.copy);
    if (result.shadows) row["shadows"] = candela::toString(*result.shadows);
    if (result.occlusion) row["occlusion"] = shadowJson(*result.occlusion);
    if (const auto cost = shadowCost(result, results)) row["shadow_cost"] = costJson(*cost);
    if (result.samples > 1) row["samples"] = result.samples;
    if (const auto frames = singleFrames(result, results)) row["single_frames"] = *frames;
    if (result.shadowMaps) row["shadow_maps"] = shadowMapsJson(*result.shadowMaps);
    put(row, "ceiling_share", ceilingShare(result, ceiling));
    if (result.difference)
        row["difference"] = {{"from", result.difference->from},
                             {"max", result.difference->max},
                             {"mean", result.difference->mean}};
    return row;
}

/// The cost of the lights beyond those of the reference.
std::string referenceText(const Result& result) {
    const double more = result.lighting.value_or(0.0) - result.reference->lighting;
    std::string text = rowName(result) + ", " + std::to_string(result.lights) + " lights against " +
                       std::to_string(result.reference->lights) + ": " + fixedText(more, 3) + " ms more";
    if (result.reference->lights > 0)
        text += ", " + fixedText(100.0 * more / result.reference->lighting, 1) + " %";
    if (result.reference->lights == 0 && result.copy && *result.copy > 0.0)
        text += ", " + fixedText(more / *result.copy, 2) + " plain copies of their array (" +
                fixedText(result.copy, 3) + " ms)";
    return text + "\n";
}

std::string samplesText(const Result& result, const std::vector<Result>& results) {
    const auto frames = singleFrames(result, results);
    if (!frames) return "";
    return rowName(result) + ", " + std::to_string(result.lights) + " lights: the time of " +
           fixedText(*frames, 2) + " frames of one sample\n";
}

/// Of scenes that measure the geometry pass.
std::string geometryText(const Result& result) {
    if (!isTriangles(result.scene) || !result.triangles || !result.geometry) return "";
    const auto triangles = static_cast<double>(*result.triangles);
    return rowName(result) + ", " + std::to_string(result.lights) + " lights: geometry takes " +
           fixedText(*result.geometry * 1.0e6 / triangles, 2) + " ns a triangle of the scene\n";
}

std::string shadowText(const Result& result, const std::vector<Result>& results) {
    std::string text;
    const auto add = [&](const std::string& line) {
        text += rowName(result) + ", " + std::to_string(result.lights) + " lights: " + line + "\n";
    };
    if (const auto& maps = result.shadowMaps)
        add(std::to_string(maps->lights) + " drawn, " + fixedText(maps->millisecondsPerLight(), 3) +
            " ms a light");
    if (result.occlusion) {
        const candela::ShadowCounts& rays = result.occlusion->rays;
        const candela::OcclusionReport& structure = result.occlusion->structure;
        add(millionsText(rays.raysAsked) + " M rays asked, " + millionsText(rays.raysTraced) + " M traced, " +
            millionsText(rays.raysSaved) + " M saved; structure of " + std::to_string(structure.triangles) +
            " triangles, " + std::to_string(structure.instances) + " instances, " +
            fixedText(static_cast<double>(structure.bytes) * 1.0e-6, 1) + " MB, built in " +
            fixedText(structure.buildMilliseconds, 1) + " ms, updated in " +
            fixedText(structure.updateMilliseconds, 2) + " ms");
    }
    if (const auto cost = shadowCost(result, results)) {
        std::string line = "frame " + fixedText(cost->frameRatio, 2) + " times, lighting " +
                           fixedText(cost->lightingRatio, 2) + " times what it takes without";
        if (cost->millisecondsPerLight)
            line += ", " + fixedText(*cost->millisecondsPerLight, 4) + " ms a light in view";
        if (cost->shadowMapRatio)
            line += "; a cube shadow map takes " + fixedText(cost->shadowMapRatio, 1) + " times as long";
        add(line);
    }
    return text;
}

/// Lighting time of the textbook programs over candela's, and candela's frame time over the bare one. Empty
/// where no baseline was measured with this number of lights.
std::string baselineText(const Result& own, const std::vector<Result>& results) {
    std::string text;
    for (const Result& other : results) {
        if (other.error || other.lights != own.lights || isCandela(other)) continue;
        if (other.technique == "bare")
            text += ", frame " + fixedText(own.frame / other.frame, 2) + " times bare";
        else if (other.lighting && own.lighting.value_or(0.0) > 0.0)
            text += ", lighting " + fixedText(*other.lighting / *own.lighting, 1) + " times as fast as " +
                    other.technique;
    }
    if (text.empty()) return text;
    return rowName(own) + ", " + std::to_string(own.lights) + " lights: " + text.substr(2) + "\n";
}

}  // namespace

bool isCandela(const Result& result) {
    return result.technique != "bare" && result.technique != "cube_shadow_maps" &&
           !result.technique.starts_with("textbook");
}

std::string rowName(const Result& result) {
    return result.technique +
           (result.backendShown && result.tileBackend ? " on " + *result.tileBackend : "") +
           (result.shadows == candela::Shadows::on ? ", shadows" : "") +
           (result.samples > 1 ? ", " + std::to_string(result.samples) + " samples" : "");
}

std::string setupJson(const BenchOptions& options) {
    Json setup{
        {"version", CANDELA_VERSION},
        {"cpu", cpuName()},
        {"cores", candela::availableThreads()},
        {"threads", candela::threadCount()},
        {"system", systemName()},
        {"opengl", reinterpret_cast<const char*>(glGetString(GL_VERSION))},
        {"brdf", candela::toString(options.brdf)},
        {"view", options.view.value_or("")},
    };
    const char* set = std::getenv("CANDELA_INSTRUCTION_SET");
    if (set != nullptr && *set != '\0') setup["instruction_set"] = set;
    if (options.environment.source != EnvironmentOption::Source::own)
        setup["environment"] = toString(options.environment);
    return setup.dump();
}

std::string resultsJson(const std::string& renderer, const std::string& setup,
                        const std::vector<Result>& results, const std::optional<Ceiling>& ceiling) {
    Json rows = Json::array();
    for (const Result& result : results) rows.push_back(rowOf(result, results, ceiling));
    Json json{{"renderer", renderer}, {"setup", Json::parse(setup)}};
    if (ceiling) json["ceiling"] = ceilingJson(*ceiling);
    json["results"] = std::move(rows);
    constexpr int indent = 2;
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string resultsTable(const std::vector<Result>& results) {
    std::ostringstream table;
    std::array widths{9, 9, 20, 10, 10, 10, 10, 11, 11, 6, 8, 10};
    for (const Result& r : results) widths[0] = std::max(widths[0], static_cast<int>(r.scene.size()));
    const auto line = [&](const std::array<std::string, 12>& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            table << (i == 0 || i == 2 ? std::left : std::right) << std::setw(widths[i]) << cells[i] << ' ';
        }
        table << '\n';
    };
    line({"scene", "lights", " technique", "frame ms", "geometry", "lighting", "display", "lit M",
          "evaluated M", "lit %", "M lit/s", "difference"});
    for (const Result& r : results) {
        if (r.error) {
            line({r.scene, std::to_string(r.lights), " " + rowName(r), "failed", "-", "-", "-", "-", "-", "-",
                  "-", "-"});
            continue;
        }
        line({r.scene, std::to_string(r.lights), " " + rowName(r), fixedText(r.frame, 2),
              fixedText(r.geometry, 2), fixedText(r.lighting, 2), fixedText(r.display, 2),
              millionsText(r.pairsLit), millionsText(r.pairsEvaluated), shareText(r), rateText(r),
              r.difference ? fixedText(r.difference->mean, 6) : "-"});
    }
    for (const Result& result : results) {
        if (result.error) {
            table << rowName(result) << ", " << result.lights << " lights: not measured: " << *result.error
                  << "\n";
            continue;
        }
        table << geometryText(result);
        if (result.reference) table << referenceText(result);
        if (isCandela(result)) table << baselineText(result, results);
        table << shadowText(result, results) << samplesText(result, results);
    }
    return table.str();
}
