#include "settings.h"

#include "common/output_file.h"
#include "common/parse.h"
#include "common/shadow_stats.h"

#include <candela/error.h>
#include <candela/sampling.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* settingsName = "view.json";
constexpr const char* layoutName = "view-layout.ini";
constexpr int maxSide = 16384;
constexpr std::size_t keptRecent = 10;

/// The panels by name.
template <typename Panels, typename Visit>
void visitPanels(Panels& panels, Visit&& visit) {
    visit("scene", panels.scene);
    visit("material", panels.material);
    visit("lights", panels.lights);
    visit("camera", panels.camera);
    visit("color", panels.color);
    visit("drawing", panels.drawing);
    visit("statistics", panels.statistics);
    visit("probe", panels.probe);
    visit("timeline", panels.timeline);
}

Json toJson(const ViewModel& model) {
    const SceneOptions& options = model.options;
    Json panels = Json::object();
    visitPanels(model.panels, [&](const char* name, bool open) { panels[name] = open; });
    const DockSizes& docks = model.dockSizes;
    return {{"size", {model.windowSize.x, model.windowSize.y}},
            {"panels", panels},
            {"docks", {docks.left, docks.right, docks.bottom}},
            {"panel_weights", docks.weights},
            {"text_scale", model.textScale},
            {"recent", model.recent},
            {"brdf", candela::toString(options.brdf)},
            {"technique", candela::toString(options.technique)},
            {"shadows", candela::toString(drawnShadows(options.shadows))},
            {"specular_antialiasing", options.specularAntialiasing},
            {"samples", options.sampling.count.value_or(defaultViewSamples)},
            {"ocio", options.ocio.value_or("")},
            {"display", options.display.display},
            {"view", options.display.view},
            {"look", options.display.look},
            {"subdivision_edge", options.subdivision.edgePixels},
            {"subdivision_max_level", options.subdivision.maxLevel}};
}

/// Sizes that no window has become some that one can have.
void readDocks(const Json& json, ViewModel& model) {
    DockSizes sizes;
    const auto letters = json.at("docks").get<std::array<float, 3>>();
    constexpr float most = 1000.0f, least = 1.0e-3f;
    sizes.left = std::clamp(letters[0], 1.0f, most);
    sizes.right = std::clamp(letters[1], 1.0f, most);
    sizes.bottom = std::clamp(letters[2], 1.0f, most);
    sizes.weights = json.at("panel_weights").get<std::array<float, panelCount>>();
    for (float& weight : sizes.weights) weight = std::clamp(weight, least, most);
    model.textScale = std::clamp(json.at("text_scale").get<float>(), 0.5f, 3.0f);
    model.dockSizes = sizes;
}

void readSize(const Json& json, SceneOptions& options) {
    const auto [width, height] = json.at("size").get<std::pair<int, int>>();
    options.width = std::clamp(width, 1, maxSide);
    options.height = std::clamp(height, 1, maxSide);
}

void readColor(const Json& json, SceneOptions& options) {
    const auto config = json.at("ocio").get<std::string>();
    if (!config.empty()) options.ocio = config;
    options.display.display = json.at("display").get<std::string>();
    options.display.view = json.at("view").get<std::string>();
    options.display.look = json.at("look").get<std::string>();
}

void readSamples(const Json& json, SamplingOptions& sampling) {
    sampling.count = std::clamp(json.at("samples").get<std::uint32_t>(), 1u, candela::maxSamples);
}

void readSubdivision(const Json& json, SceneOptions& options) {
    options.subdivision.edgePixels = std::clamp(json.at("subdivision_edge").get<float>(), 0.1f, 1.0e5f);
    options.subdivision.maxLevel =
        std::clamp(json.at("subdivision_max_level").get<std::uint32_t>(), 1u, candela::maxSubdivisionLevel);
}

/// Into copies, so that a file with a mistake leaves everything as it was.
void takeSettings(const Json& json, const ViewOptions& given, ViewModel& model) {
    SceneOptions options = model.options;
    OpenPanels panels = model.panels;
    auto recent = json.at("recent").get<std::vector<std::string>>();
    visitPanels(panels, [&](const char* name, bool& open) { open = json.at("panels").at(name).get<bool>(); });
    if (!given.sizeGiven) readSize(json, options);
    if (!given.displayGiven) readColor(json, options);
    if (!options.sampling.count) readSamples(json, options.sampling);
    if (!given.subdivisionGiven) readSubdivision(json, options);
    if (!given.drawingGiven) {
        options.brdf = parseBrdf(json.at("brdf").get<std::string>());
        options.technique = parseTechnique(json.at("technique").get<std::string>());
        options.shadows = parseShadows(json.at("shadows").get<std::string>());
        options.specularAntialiasing = json.at("specular_antialiasing").get<bool>();
    }
    readDocks(json, model);
    model.options = options;
    model.panels = panels;
    model.recent = std::move(recent);
}

/// The next session may begin in another folder.
std::string rememberedName(const std::string& scene) {
    std::error_code failed;
    if (!std::filesystem::exists(scene, failed)) return scene;
    const std::filesystem::path absolute = std::filesystem::absolute(scene, failed);
    return failed ? scene : absolute.string();
}

}  // namespace

std::filesystem::path settingsFolder() {
    const char* configured = std::getenv("XDG_CONFIG_HOME");
    if (configured && *configured) return std::filesystem::path(configured) / "candela";
    const char* home = std::getenv("HOME");
    if (home && *home) return std::filesystem::path(home) / ".config" / "candela";
    return {};
}

void readSettings(const std::filesystem::path& folder, const ViewOptions& options, ViewModel& model) {
    if (folder.empty()) return;
    const std::filesystem::path file = folder / settingsName;
    std::ifstream stream(file);
    if (!stream) return;
    try {
        takeSettings(Json::parse(stream), options, model);
    } catch (const std::exception& error) {
        model.messages.push_back(
            {Message::Kind::note,
             file.string() + ": the settings of the last session are not used: " + error.what()});
    }
}

void writeSettings(const std::filesystem::path& folder, const ViewModel& model) {
    if (folder.empty()) return;
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);  // writing reports the error
    // A file's name need not be UTF-8.
    const std::string text = toJson(model).dump(2, ' ', false, Json::error_handler_t::replace);
    writeText(folder / settingsName, text + "\n");
}

void forgetSettings(const std::filesystem::path& folder) {
    if (folder.empty()) return;
    for (const char* name : {settingsName, layoutName}) {
        std::error_code failed;
        std::filesystem::remove(folder / name, failed);  // none to remove is no failure
        if (failed)
            throw candela::Error(candela::ErrorKind::environment, (folder / name).string(),
                                 "cannot be removed: " + failed.message());
    }
}

std::filesystem::path layoutFile(const std::filesystem::path& folder) {
    return folder.empty() ? folder : folder / layoutName;
}

void rememberScene(std::vector<std::string>& recent, const std::string& scene) {
    const std::string name = rememberedName(scene);
    std::erase(recent, name);
    recent.insert(recent.begin(), name);
    if (recent.size() > keptRecent) recent.resize(keptRecent);
}
