#include "results.h"

#include <candela/threads.h>
#include <candela/version.h>

#include <epoxy/gl.h>
#include <sys/utsname.h>
#include <nlohmann/json.hpp>

#include <array>
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

std::string fixedText(const std::optional<double>& value, int digits) {
    if (!value) return "-";
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << *value;
    return text.str();
}

std::string millionsText(const std::optional<std::uint64_t>& value) {
    return value ? fixedText(static_cast<double>(*value) * 1.0e-6, 2) : "-";
}

/// Millions of lit pairs a second of the lighting pass.
std::string rateText(const Result& result) {
    if (!result.pairsLit || !result.lighting || *result.lighting <= 0.0) return "-";
    return fixedText(static_cast<double>(*result.pairsLit) / *result.lighting * 1.0e-3, 1);
}

std::string shareText(const Result& result) {
    if (!result.pairsLit || !result.pairsEvaluated || *result.pairsEvaluated == 0) return "-";
    return fixedText(
        100.0 * static_cast<double>(*result.pairsLit) / static_cast<double>(*result.pairsEvaluated), 0);
}

Json failedRow(const Result& result) {
    return {{"scene", result.scene}, {"lights", result.lights}, {"technique", result.technique},
            {"width", result.width}, {"height", result.height}, {"error", *result.error}};
}

// The first eleven keys are a contract: other programs read them.
Json rowOf(const Result& result) {
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
    put(row, "lights_visible", result.lightsVisible);
    put(row, "lights_dropped", result.lightsDropped);
    put(row, "light_list_bytes", result.lightListBytes);
    put(row, "picture_ms", result.picture);
    put(row, "set_lights_ms", result.setLights);
    if (result.reference) {
        row["reference_lights"] = result.reference->lights;
        row["reference_lighting_ms"] = result.reference->lighting;
    }
    put(row, "copy_ms", result.copy);
    if (result.difference)
        row["difference"] = {{"from", result.difference->from},
                             {"max", result.difference->max},
                             {"mean", result.difference->mean}};
    return row;
}

/// The cost of the lights beyond those of the reference.
std::string referenceText(const Result& result) {
    const double more = result.lighting.value_or(0.0) - result.reference->lighting;
    std::string text = result.technique + ", " + std::to_string(result.lights) + " lights against " +
                       std::to_string(result.reference->lights) + ": " + fixedText(more, 3) + " ms more";
    if (result.reference->lights > 0)
        text += ", " + fixedText(100.0 * more / result.reference->lighting, 1) + " %";
    if (result.reference->lights == 0 && result.copy && *result.copy > 0.0)
        text += ", " + fixedText(more / *result.copy, 2) + " plain copies of their array (" +
                fixedText(result.copy, 3) + " ms)";
    return text + "\n";
}

/// Lighting time of the textbook programs over candela's, and candela's frame time over the bare one. Empty
/// where no baseline was measured with this number of lights.
std::string baselineText(const Result& own, const std::vector<Result>& results) {
    std::string text;
    for (const Result& other : results) {
        if (other.error || other.lights != own.lights || isCandela(other)) continue;
        if (other.technique == "bare")
            text += ", frame " + fixedText(own.frame / other.frame, 2) + " times bare";
        else if (own.lighting.value_or(0.0) > 0.0)
            text += ", lighting " + fixedText(*other.lighting / *own.lighting, 1) + " times as fast as " +
                    other.technique;
    }
    if (text.empty()) return text;
    return own.technique + ", " + std::to_string(own.lights) + " lights: " + text.substr(2) + "\n";
}

}  // namespace

bool isCandela(const Result& result) {
    return result.technique != "bare" && !result.technique.starts_with("textbook");
}

std::string setupJson(const BenchOptions& options) {
    const Json setup{
        {"version", CANDELA_VERSION},
        {"cpu", cpuName()},
        {"cores", candela::availableThreads()},
        {"threads", candela::threadCount()},
        {"system", systemName()},
        {"opengl", reinterpret_cast<const char*>(glGetString(GL_VERSION))},
        {"brdf", candela::toString(options.brdf)},
        {"view", options.view.value_or("")},
    };
    return setup.dump();
}

std::string resultsJson(const std::string& renderer, const std::string& setup,
                        const std::vector<Result>& results) {
    Json rows = Json::array();
    for (const Result& result : results) rows.push_back(rowOf(result));
    const Json json{{"renderer", renderer}, {"setup", Json::parse(setup)}, {"results", std::move(rows)}};
    constexpr int indent = 2;
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string resultsTable(const std::vector<Result>& results) {
    std::ostringstream table;
    const auto line = [&](const std::array<std::string, 12>& cells) {
        constexpr std::array widths{9, 9, 20, 10, 10, 10, 10, 11, 11, 6, 8, 10};
        for (std::size_t i = 0; i < cells.size(); ++i) {
            table << (i == 0 || i == 2 ? std::left : std::right) << std::setw(widths[i]) << cells[i] << ' ';
        }
        table << '\n';
    };
    line({"scene", "lights", " technique", "frame ms", "geometry", "lighting", "display", "lit M",
          "evaluated M", "lit %", "M lit/s", "difference"});
    for (const Result& r : results) {
        if (r.error) {
            line({r.scene, std::to_string(r.lights), " " + r.technique, "failed", "-", "-", "-", "-", "-",
                  "-", "-", "-"});
            continue;
        }
        line({r.scene, std::to_string(r.lights), " " + r.technique, fixedText(r.frame, 2),
              fixedText(r.geometry, 2), fixedText(r.lighting, 2), fixedText(r.display, 2),
              millionsText(r.pairsLit), millionsText(r.pairsEvaluated), shareText(r), rateText(r),
              r.difference ? fixedText(r.difference->mean, 6) : "-"});
    }
    for (const Result& result : results) {
        if (result.error) {
            table << result.technique << ", " << result.lights << " lights: not measured: " << *result.error
                  << "\n";
            continue;
        }
        if (result.reference) table << referenceText(result);
        if (isCandela(result)) table << baselineText(result, results);
    }
    return table.str();
}
