#pragma once

#include "arithmetic_ceiling.h"
#include "bench_options.h"
#include "common/shadow_stats.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The difference of the radiance from the reference radiance, relative to the mean of the reference.
struct Difference {
    std::string from;  ///< The technique of the reference.
    double max = 0.0, mean = 0.0;
};

/// The lighting pass of the same scene with the first of its lights only.
struct ReferenceLights {
    std::uint64_t lights = 0;
    double lighting = 0.0;
};

/// Cube shadow maps, see `measureShadowMaps`.
struct ShadowMaps {
    std::uint64_t lights = 0;     ///< Those whose map was drawn.
    std::uint64_t triangles = 0;  ///< Drawn, of all maps and faces together.
    double milliseconds = 0.0;    ///< Of all maps together.

    double millisecondsPerLight() const { return milliseconds / static_cast<double>(lights); }
};

/// The measurements of one program on one scene: a row of the report. Times are medians in milliseconds.
struct Result {
    std::string scene;
    std::uint64_t lights = 0;
    /// candela's, or "textbook_fullscreen", "textbook_volumes", "bare", "cube_shadow_maps".
    std::string technique;
    std::optional<candela::Shadows> shadows;  ///< Of candela's rows: `on` or `off`.
    std::uint32_t samples = 1;                ///< A pixel; times are of all of them together.
    int width = 0, height = 0;
    /// The reason why the program could not draw the scene; all that follows is then unset.
    std::optional<std::string> error;
    std::optional<std::string> tileBackend;  ///< What ran `tiles`: "cpu" or "compute".
    bool backendShown = false;               ///< Where `tiles` was measured on more than one.
    int frames = 0;                          ///< Number of frames that the medians are taken over.
    double frame = 0.0;
    std::optional<double> geometry, lighting, display;
    /// With an environment: its rays; its light where shaders add it; what is seen of it.
    std::optional<double> ambientOcclusion, environment, background;
    std::optional<std::uint64_t> pairsLit, pairsEvaluated, lightsVisible, lightsDropped, lightListBytes;
    std::optional<std::uint64_t> triangles;  ///< Of the scene, in view or not.
    std::optional<double> picture;           ///< Wall clock of a frame, read-back included.
    std::optional<double> setLights;         ///< Wall clock of one `GpuScene::setLights` with all lights.
    std::optional<Difference> difference;
    std::optional<ReferenceLights> reference;
    std::optional<double> copy;            ///< A memcpy of the array of lights.
    std::optional<ShadowStats> occlusion;  ///< With shadows: of the frame drawn last.
    std::optional<ShadowMaps> shadowMaps;
};

/// The setup of a run as a JSON object: {"version", "cpu", "cores", "threads", "system", "opengl", "brdf",
/// "view"} and, where it is an option, "environment". `cores` are those that the process may use, `threads`
/// those that candela uses. Needs a current context.
std::string setupJson(const BenchOptions& options);

/// {"renderer", "setup", "results": [...]}. A failed result has "error" in place of measurements. Times and
/// pairs that a program does not have are 0; further keys that were not measured are left out. `setup` is the
/// text of `setupJson`. With a ceiling also "ceiling", and "ceiling_share" in the rows that shaders have lit.
std::string resultsJson(const std::string& renderer, const std::string& setup,
                        const std::vector<Result>& results, const std::optional<Ceiling>& ceiling = {});

/// The results as a table, and ratios derived from them; docs/benchmarks.md explains the columns.
std::string resultsTable(const std::vector<Result>& results);

/// Lighting time against the number of lights as an SVG image, both axes logarithmic, one line a technique.
/// One number of lights gives points instead of lines.
std::string plotSvg(const std::string& renderer, const std::vector<Result>& results);

/// The technique, whether it was measured with shadows, and with how many samples: what tables and plots call
/// the row.
std::string rowName(const Result& result);

/// Does the row belong to candela itself, not to a baseline?
bool isCandela(const Result& result);
