#pragma once

#include <candela/renderer.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// How far a picture is from the one it is compared with, as shares of the mean of that picture.
struct Difference {
    std::string from;  ///< The other's technique.
    double max = 0.0, mean = 0.0;
};

/// The same scene with only the first of its lights.
struct ReferenceLights {
    std::uint64_t lights = 0;
    double lighting = 0.0;
};

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
    std::optional<double> picture;    ///< Wall clock of a frame up to its finished picture in memory.
    std::optional<double> setLights;  ///< Wall clock of handing over all lights anew.
    std::optional<Difference> difference;
    std::optional<ReferenceLights> reference;
    std::optional<double> copy;  ///< A plain copy of the lights' array.
};

/// The contract's JSON: {"renderer", "setup", "results": [...]}. Times and pairs that a program has not are
/// 0; further keys that were not measured are left out. `setup` is the JSON text of `setupJson`.
std::string resultsJson(const std::string& renderer, const std::string& setup,
                        const std::vector<Result>& results);

/// The results as a table for people, and what follows from them; columns are explained in
/// docs/benchmarks.md.
std::string resultsTable(const std::vector<Result>& results);
