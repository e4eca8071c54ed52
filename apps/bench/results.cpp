#include "results.h"

#include <nlohmann/json.hpp>

#include <array>
#include <iomanip>
#include <sstream>

namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

std::string resultsJson(const std::string& renderer, const std::vector<Result>& results) {
    Json rows = Json::array();
    for (const Result& result : results) {
        Json row{{"scene", result.scene},   {"lights", result.lights}, {"technique", result.technique},
                 {"width", result.width},   {"height", result.height}, {"frames", result.frames},
                 {"frame_ms", result.frame}};
        put(row, "geometry_ms", result.geometry);
        put(row, "lighting_ms", result.lighting);
        put(row, "display_ms", result.display);
        put(row, "pairs_lit", result.pairsLit);
        put(row, "pairs_evaluated", result.pairsEvaluated);
        put(row, "lights_visible", result.lightsVisible);
        put(row, "lights_dropped", result.lightsDropped);
        put(row, "light_list_bytes", result.lightListBytes);
        put(row, "difference", result.difference);
        if (!result.reference.empty()) row["difference_from"] = result.reference;
        rows.push_back(std::move(row));
    }
    const Json json{{"renderer", renderer}, {"results", std::move(rows)}};
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
        line({r.scene, std::to_string(r.lights), " " + r.technique, fixedText(r.frame, 2),
              fixedText(r.geometry, 2), fixedText(r.lighting, 2), fixedText(r.display, 2),
              millionsText(r.pairsLit), millionsText(r.pairsEvaluated), shareText(r), rateText(r),
              fixedText(r.difference, 6)});
    }
    return table.str();
}
