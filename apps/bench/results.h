#pragma once

#include <candela/renderer.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What was measured of one technique at one scene: a row of the report. Times are medians in milliseconds.
struct Result {
    std::string scene;
    std::uint64_t lights = 0;
    std::string technique;  ///< candela's, or "textbook_fullscreen", "textbook_volumes", "bare".
    int width = 0, height = 0;
    int frames = 0;  ///< How many the medians are of.
    double frame = 0.0;
    std::optional<double> geometry, lighting, display;
    std::optional<std::uint64_t> pairsLit, pairsEvaluated, lightsVisible, lightsDropped, lightListBytes;
    std::optional<double>
        difference;  ///< Mean difference from the reference's picture, as a share of the reference's mean.
    std::string reference;  ///< The technique compared with.
};

/// The contract's JSON: {"renderer", "results": [...]}. What was not measured is left out of a row.
std::string resultsJson(const std::string& renderer, const std::vector<Result>& results);

/// The results as a table for people; columns are explained in docs/benchmarks.md.
std::string resultsTable(const std::vector<Result>& results);
