#include "view_options.h"

#include "common/command_line.h"
#include "common/parse.h"
#include "shortcuts.h"

#include <algorithm>
#include <cctype>
#include <limits>

namespace {

constexpr const char* description =
    "Shows a scene lit by any number of point lights in a window. SCENE may be left out: drop a file on the\n"
    "window. Takes the options of candela-render and draws the same picture.\n";

std::string footer() {
    return "In the window:\n" + controlsText() +
           "\n"
           "Exit codes:\n"
           "  0  done\n"
           "  1  this machine is at fault, or the scene of a run with --frames or --screenshot; one line "
           "says why\n"
           "  2  wrong usage";
}

void declareWindow(CLI::App& app, ViewOptions& options) {
    app.add_option_function<std::string>(
           "--frames",
           [&options](const std::string& text) {
               options.frames = static_cast<std::uint32_t>(
                   parseInteger("--frames", text, 1, std::numeric_limits<std::int32_t>::max()));
           },
           "End after N frames of the scene")
        ->type_name("N")
        ->group("Running");
    app.add_option("--screenshot", options.screenshot,
                   "Write the picture, without the panels, and end: .png as the display shows it,\n"
                   ".exr with all channels. Such a run, and one with --frames, keeps no settings")
        ->type_name("FILE")
        ->group("Running");
    app.add_option("--window-screenshot", options.windowScreenshot,
                   "Write the whole window with its panels as a PNG, and end")
        ->type_name("FILE.png")
        ->group("Running");
    app.add_flag_callback(
           "--reset", [&options] { options.settings = StoredSettings::reset; },
           "Forget the settings that earlier sessions left")
        ->group("Running");
}

void noteGiven(const CLI::App& app, ViewOptions& options) {
    const auto given = [&app](const char* name) { return app.count(name) > 0; };
    options.sizeGiven = given("--size");
    options.displayGiven = given("--ocio") || given("--display") || given("--view") || given("--look");
    options.exposureGiven = given("--exposure");
    options.drawingGiven = given("--brdf") || given("--technique") || given("--tiles") ||
                           given("--shadows") || given("--show") || given("--specular-aa");
    options.subdivisionGiven =
        given("--subdivision-level") || given("--subdivision-edge") || given("--subdivision-max-level");
}

void check(const ViewOptions& options) {
    if (options.screenshot && options.scene.empty()) throw UsageError("--screenshot needs a SCENE");
    if (options.screenshot && endingOf(*options.screenshot) != ".png" &&
        endingOf(*options.screenshot) != ".exr")
        throw UsageError("--screenshot \"" + options.screenshot->string() +
                         "\": expected a file name that ends in .png or .exr");
    if (options.windowScreenshot && endingOf(*options.windowScreenshot) != ".png")
        throw UsageError("--window-screenshot \"" + options.windowScreenshot->string() +
                         "\": expected a file name that ends in .png");
}

}  // namespace

std::string endingOf(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    return ending;
}

std::optional<ViewOptions> parseViewOptions(int argc, const char* const* argv) {
    ViewOptions options;
    CLI::App app(description, "candela-view");
    prepareCommandLine(app);
    app.footer(footer());
    SceneOptionReader sceneOptions(app, options, defaultViewSamples);
    declareWindow(app, options);
    if (!parseCommandLine(app, argc, argv)) return std::nullopt;
    sceneOptions.finish();
    noteGiven(app, options);
    check(options);
    return options;
}
