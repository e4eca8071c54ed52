#include "options.h"

#include "common/command_line.h"
#include "common/parse.h"
#include "common/program.h"
#include "farm_options.h"
#include "help.h"

#include <candela/gbuffer.h>
#include <candela/nearest_name.h>
#include <candela/picture_parts.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace {

constexpr double maxDistance = 1.0e9;
constexpr std::int64_t maxRays = 4096;
constexpr int maxFrameSide = 16384;
/// 8K UHD fits. Software devices take some 60 bytes a pixel.
constexpr std::int64_t maxWholePixels = std::int64_t{1} << 25;
/// Of larger pictures: low, so that memory holds few rows.
constexpr int partWidth = 8192, partHeight = 1024;
constexpr std::pair defaultPanorama{2048, 1024};

ListKind parseListKind(const std::string& text) {
    using enum ListKind;
    return parseWord("--list", text,
                     std::array{plugins, devices, displays, views, animations, cameras, materials, variants,
                                environment, contents},
                     [](ListKind kind) {
                         constexpr std::array names{"plugins",     "devices", "displays",  "views",
                                                    "animations",  "cameras", "materials", "variants",
                                                    "environment", "contents"};
                         return names[static_cast<std::size_t>(kind)];
                     });
}

std::vector<std::string> parseAovs(const std::string& text) {
    if (text == "all") return candela::Renderer::aovNames();
    std::vector<std::string> known;
    for (const candela::GBufferChannel& channel : candela::gbufferChannels())
        known.emplace_back(channel.name);
    std::vector<std::string> names = splitAtCommas(text);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (std::ranges::find(known, names[i]) == known.end()) {
            std::string list = "all";
            for (const std::string& name : known) list += ", " + name;
            throw UsageError("--aov \"" + names[i] + "\": expected some of " + list +
                             candela::didYouMean(names[i], known));
        }
        if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
            names.begin() + static_cast<std::ptrdiff_t>(i))
            throw UsageError("--aov \"" + text + "\": " + names[i] + " is given twice");
    }
    return names;
}

candela::AovFilter parseAovFilter(const std::string& text) {
    using enum candela::AovFilter;
    return parseWord("--aov-filter", text, std::array{automatic, average, first},
                     [](candela::AovFilter filter) { return candela::toString(filter); });
}

/// True for "json".
bool parseProgress(const std::string& text) {
    return parseWord("--progress", text, std::array{false, true},
                     [](bool json) { return json ? "json" : "terminal"; });
}

/// The names that the library has, in lines as wide as those of the other texts.
std::string aovHelp() {
    constexpr std::size_t lineWidth = 78;
    std::string text = "More channels for an .exr, separated by commas:";
    std::size_t lineStart = 0;
    const std::vector<std::string> names = candela::Renderer::aovNames();
    for (const std::string& name : names) {
        const bool fits = text.size() - lineStart + name.size() + 2 <= lineWidth;
        if (!fits) lineStart = text.size() + 1;
        text += (fits ? " " : "\n") + name + (&name == &names.back() ? "" : ",");
    }
    return text;
}

void declarePicture(CLI::App& app, Options& options, std::optional<std::string>& aovs) {
    app.add_option("-o,--output", options.output, help::output)->type_name("FILE")->group("Picture");
    app.add_option("--aov", aovs, aovHelp())->type_name("all|LIST")->group("Picture");
    app.add_option_function<std::string>(
           "--aov-filter", [&](const std::string& text) { options.aovFilter = parseAovFilter(text); },
           help::aovFilter)
        ->type_name("auto|average|first")
        ->group("Picture");
    app.add_flag("--panorama", options.panorama, help::panorama)->group("Picture");
    app.add_option_function<std::string>(
           "--tile",
           [&options](const std::string& text) {
               options.tile =
                   static_cast<int>(parseInteger("--tile", text, candela::minPartSide, maxFrameSide));
           },
           help::tile)
        ->type_name("N")
        ->group("Picture");
    candela::AmbientOcclusionSettings& ambientOcclusion = options.ambientOcclusion;
    app.add_option_function<std::string>(
           "--ao-distance",
           [&ambientOcclusion](const std::string& text) {
               ambientOcclusion.distance =
                   static_cast<float>(parseNumberBetween("--ao-distance", text, 0.0, maxDistance));
           },
           help::aoDistance)
        ->type_name("METRES")
        ->group("Picture");
    app.add_option_function<std::string>(
           "--ao-rays",
           [&ambientOcclusion](const std::string& text) {
               ambientOcclusion.rays =
                   static_cast<std::uint32_t>(parseInteger("--ao-rays", text, 1, maxRays));
           },
           help::aoRays)
        ->type_name("N")
        ->group("Picture");
}

void declareRunning(CLI::App& app, Options& options, std::optional<DeviceOption>& device) {
    app.add_option_function<std::string>(
           "--device", [&](const std::string& text) { device = parseDevice("--device", text); }, help::device)
        ->type_name("N|software|auto")
        ->group("Running");
    app.add_option_function<std::string>(
           "--progress", [&](const std::string& text) { options.jsonProgress = parseProgress(text); },
           help::progress)
        ->type_name("terminal|json")
        ->group("Running");
    app.add_option("--stats", options.stats, help::stats)->type_name("FILE|-")->group("Running");
    app.add_flag("--quiet", options.quiet, help::quiet)->group("Running");
    app.add_option_function<std::string>(
           "--list", [&](const std::string& text) { options.list = parseListKind(text); }, help::list)
        ->type_name(
            "plugins|devices|displays|views|animations|cameras|materials|variants|environment|contents")
        ->group("Asking");
}

/// Pictures of several frames: parts, and faces of a panorama.
void finishFrames(const CLI::App& app, Options& options) {
    if (options.panorama) {
        if (app.count("--size") == 0) std::tie(options.width, options.height) = defaultPanorama;
        if (options.width != 2 * options.height || options.width < 4)
            throw UsageError("--panorama needs a picture twice as wide as high, and 4 pixels wide or more");
        // That of "all" is left out.
        const auto motion = std::ranges::find(options.aovs, "motion");
        if (motion != options.aovs.end() && options.aovs.size() < candela::Renderer::aovNames().size())
            throw UsageError("--panorama has no AOV motion, whose ways are of a plane");
        if (motion != options.aovs.end()) options.aovs.erase(motion);
        if (!options.debug.isDefault()) throw UsageError("--panorama can not be combined with --show");
        if (options.tile) throw UsageError("--panorama can not be combined with --tile");
    }
    if (!options.panorama && !options.isParted()) return;
    using enum candela::DebugView;
    for (const candela::DebugView view : {depth, lightCount, shadowedCount}) {
        if (options.debug.view != view) continue;
        throw UsageError(std::string("--show ") + candela::toString(view) +
                         " is scaled by the whole picture, which can not be drawn in parts");
    }
}

void resolve(const CLI::App& app, const std::optional<std::string>& aovs, Options& options) {
    if (options.scene.empty() && (!options.list || needsScene(*options.list)))
        throw UsageError("SCENE is missing: name a file such as room.glb, or plaza:4096");
    if (options.list) return;
    finishOutput(app, options);
    const bool exr = options.format == PictureFormat::exr;
    if (aovs) options.aovs = parseAovs(*aovs);
    if (aovs && !exr) throw UsageError("--aov needs an .exr picture: name one with -o");
    if (app.count("--aov-filter") > 0 && !aovs) throw UsageError("--aov-filter needs --aov");
    for (const char* option : {"--ao-distance", "--ao-rays"}) {
        if (app.count(option) > 0 &&
            std::ranges::find(options.aovs, "ambient_occlusion") == options.aovs.end())
            throw UsageError(std::string(option) + " needs --aov ambient_occlusion");
    }
    if (exr && !options.debug.isDefault())
        throw UsageError("--show needs a .png picture; --aov puts such channels into an .exr");
    finishFrames(app, options);
}

}  // namespace

Options::FrameSize Options::frameSize() const {
    if (tile) return {*tile, *tile};
    // The faces of a panorama are whole.
    const bool isWhole = panorama || (std::max(width, height) <= maxFrameSide &&
                                      std::int64_t{width} * height <= maxWholePixels);
    if (isWhole) return {std::max(width, candela::minPartSide), std::max(height, candela::minPartSide)};
    return {partWidth, partHeight};
}

candela::SamplingSettings Options::samplingSettings() const {
    candela::SamplingSettings settings = sampling.settings(defaultSamples);
    if (!debug.isDefault()) settings.count = 1;
    return settings;
}

std::optional<Options> parseOptions(int argc, const char* const* argv) {
    Options options;
    std::optional<std::string> aovs;
    std::optional<DeviceOption> device;
    CLI::App app(help::description, "candela-render");
    prepareCommandLine(app);
    app.footer(help::footer);
    SceneOptionReader sceneOptions(app, options, defaultSamples);
    app.get_option("--camera")->description(help::camera)->type_name("NAME|INDEX|LIST|all");
    declarePicture(app, options, aovs);
    declareEncoding(app, options);
    declareSequence(app, options);
    declareRunning(app, options, device);
    if (!parseCommandLine(app, argc, argv)) return std::nullopt;
    options.device = chooseDevice(device);
    resolve(app, aovs, options);
    if (!options.list) sceneOptions.finish();
    return options;
}
