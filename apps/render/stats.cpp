#include "stats.h"

#include "common/timing.h"

#include <candela/version.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace {

using Json = nlohmann::ordered_json;

/// The median time of each pass over all frames, in the order the passes run.
Json passTimes(const std::vector<FrameTiming>& timings) {
    std::vector<std::string> names;
    std::vector<std::vector<double>> times;
    for (const FrameTiming& timing : timings) {
        for (const candela::PassTime& pass : timing.passes) {
            const auto found = std::ranges::find(names, pass.name);
            const auto index = static_cast<std::size_t>(found - names.begin());
            if (found == names.end()) {
                names.push_back(pass.name);
                times.emplace_back();
            }
            times[index].push_back(pass.milliseconds);
        }
    }
    Json passes = Json::array();
    for (std::size_t i = 0; i < names.size(); ++i)
        passes.push_back({{"name", names[i]}, {"ms", median(times[i])}});
    return passes;
}

Json frameTimes(const std::vector<FrameTiming>& timings) {
    if (timings.empty()) return {{"median", 0.0}, {"min", 0.0}, {"max", 0.0}, {"count", 0}};
    std::vector<double> times;
    for (const FrameTiming& timing : timings) times.push_back(timing.milliseconds);
    return {{"median", median(times)},
            {"min", std::ranges::min(times)},
            {"max", std::ranges::max(times)},
            {"count", times.size()}};
}

Json countsJson(const std::vector<ContentCount>& counts) {
    Json json = Json::object();
    for (const ContentCount& count : counts) json[count.name] = count.count;
    return json;
}

Json sceneJson(const Stats& stats) {
    Json json{{"triangles", stats.triangles}, {"materials", stats.materials}, {"lights", stats.lights}};
    json.update(countsJson(stats.contents));
    json["material_kinds"] = countsJson(stats.materialKinds);
    json["lines"] = stats.lines;
    json["points"] = stats.points;
    return json;
}

Json notesJson(const std::vector<candela::ImportNote>& notes) {
    Json json = Json::array();
    for (const candela::ImportNote& note : notes)
        json.push_back({{"kind", toString(note.kind)}, {"text", note.line()}, {"count", note.count}});
    return json;
}

Json picturesJson(const std::vector<PictureResult>& pictures) {
    Json json = Json::array();
    for (const PictureResult& result : pictures)
        json.push_back({{"picture", result.picture.name()},
                        {"frame", result.picture.frame},
                        {"camera", result.camera},
                        {"draw_ms", result.drawMilliseconds},
                        {"encode_ms", result.encodeMilliseconds},
                        {"bytes", result.bytes}});
    return json;
}

}  // namespace

std::string statsJson(const Stats& stats) {
    const Json json{
        {"version", CANDELA_VERSION},
        {"renderer", stats.renderer},
        {"width", stats.width},
        {"height", stats.height},
        {"technique", candela::toString(stats.technique)},
        {"brdf", candela::toString(stats.brdf)},
        {"scene", sceneJson(stats)},
        {"passes", passTimes(stats.timings)},
        {"frame_ms", frameTimes(stats.timings)},
        {"counters",
         {{"lights", stats.lights},
          {"lights_visible", stats.pairs.lightsVisible},
          {"pairs_lit", stats.pairs.pairsLit},
          {"pairs_evaluated", stats.pairs.pairsEvaluated},
          {"lights_dropped", stats.pairs.lightsDropped}}},
        {"threads", stats.threads},
        {"tile_backend", stats.tileBackend},
        {"subdivision_evaluator", stats.vertexEvaluator},
        {"shadows", stats.shadows ? shadowJson(*stats.shadows) : Json()},
        {"environment", stats.environment},
        {"samples", stats.samples},
        {"notes", notesJson(stats.notes)},
        {"file", stats.file},
        {"driver", stats.driver},
        {"device", stats.device},
        {"pictures", picturesJson(stats.pictures)},
    };
    constexpr int indent = 2;
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}
