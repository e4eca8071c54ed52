#include "sampling_options.h"

#include "parse.h"

#include <CLI/CLI.hpp>

#include <string>

namespace {

namespace help {

constexpr const char* samples =
    "Samples a pixel, 1 to 65536: so many frames are averaged, whose eye rays are\n"
    "spread over each pixel's filter, over lens and shutter, and over lights that\n"
    "have a radius. A debug view has one. Default: ";
constexpr const char* aperture =
    "F-number of a lens, such as 2.8, between 0 and 1000: what is not at the\n"
    "distance of --focus is blurred. The aperture's diameter is 12 mm / (F-NUMBER x\n"
    "tan(fov / 2)), that of a full-frame camera. Default: a pinhole";
constexpr const char* focus =
    "Distance along the view axis that is sharp, in metres, over 0. Needs\n"
    "--aperture";
constexpr const char* blades =
    "Blades of the aperture, 3 to 64: a polygon. Default: 0, a round one. Needs\n"
    "--aperture";
constexpr const char* shutter =
    "How long the shutter is open around each picture's time, as a share of a\n"
    "frame, 0 to 1: what moves is blurred. Default: 0, an instant";
constexpr const char* pointSize = "Side of the squares that points are drawn as, in pixels. Default: 3";
constexpr const char* lineWidth = "Width of lines in pixels. Default: 1";
constexpr const char* fps = "Frames a second of --frames and --shutter, over 0. Default: 24";

}  // namespace help

constexpr double maxFNumber = 1000.0;
constexpr double maxDistance = 1.0e9;
constexpr double maxElementPixels = 16384.0;
constexpr double maxRate = 1.0e6;
constexpr std::int64_t maxBlades = 64;

std::uint32_t parseBlades(const std::string& text) {
    const std::int64_t blades = parseInteger("--blades", text, 0, maxBlades);
    if (blades == 1 || blades == 2)
        throw UsageError("--blades \"" + text + "\": expected 0 (round) or 3 to 64");
    return static_cast<std::uint32_t>(blades);
}

double parseShutter(const std::string& text) {
    const double share = parseNumber("--shutter", text);
    if (share < 0.0 || share > 1.0)
        throw UsageError("--shutter \"" + text + "\": expected a number from 0 to 1");
    return share;
}

}  // namespace

candela::SamplingSettings SamplingOptions::settings(std::uint32_t defaultCount) const {
    candela::SamplingSettings settings;
    settings.count = count.value_or(defaultCount);
    settings.shutter = shutter;
    settings.framesPerSecond = framesPerSecond;
    if (fNumber) settings.lens = candela::Lens{*fNumber, *focusDistance, blades};
    return settings;
}

void declareSampling(CLI::App& app, SamplingOptions& options, std::uint32_t defaultCount) {
    const auto add = [&app](const char* name, auto read, const std::string& text, const char* type,
                            const char* group) {
        app.add_option_function<std::string>(name, read, text)->type_name(type)->group(group);
    };
    add(
        "--samples",
        [&options](const std::string& text) {
            options.count =
                static_cast<std::uint32_t>(parseInteger("--samples", text, 1, candela::maxSamples));
        },
        help::samples + std::to_string(defaultCount), "N", "Picture");
    add(
        "--aperture",
        [&options](const std::string& text) {
            options.fNumber = static_cast<float>(parseNumberBetween("--aperture", text, 0.0, maxFNumber));
        },
        help::aperture, "F-NUMBER", "Camera");
    add(
        "--focus",
        [&options](const std::string& text) {
            options.focusDistance = static_cast<float>(parseNumberBetween("--focus", text, 0.0, maxDistance));
        },
        help::focus, "METRES", "Camera");
    add(
        "--blades", [&options](const std::string& text) { options.blades = parseBlades(text); }, help::blades,
        "N", "Camera");
    add(
        "--shutter", [&options](const std::string& text) { options.shutter = parseShutter(text); },
        help::shutter, "SHARE", "Camera");
    add(
        "--fps",
        [&options](const std::string& text) {
            options.framesPerSecond = parseNumberBetween("--fps", text, 0.0, maxRate);
        },
        help::fps, "N", "Scene");
}

void declareElementSizes(CLI::App& app, float& pointSize, float& lineWidth) {
    const auto add = [&app](const char* name, float& pixels, const char* text) {
        const auto read = [name, &pixels](const std::string& value) {
            pixels = static_cast<float>(parseNumberBetween(name, value, 0.0, maxElementPixels));
        };
        app.add_option_function<std::string>(name, read, text)->type_name("PIXELS")->group("Picture");
    };
    add("--point-size", pointSize, help::pointSize);
    add("--line-width", lineWidth, help::lineWidth);
}

void finishSampling(const CLI::App& app, const SamplingOptions& options) {
    if (options.fNumber && !options.focusDistance) throw UsageError("--aperture needs --focus too");
    for (const char* option : {"--focus", "--blades"})
        if (app.count(option) > 0 && !options.fNumber)
            throw UsageError(std::string(option) + " needs --aperture too");
    if (options.fNumber && app.count("--ortho") > 0)
        throw UsageError("--aperture and --ortho exclude each other: an orthographic view has no lens");
}
