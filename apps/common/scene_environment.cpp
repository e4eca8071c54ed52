#include "scene_environment.h"

#include "parse.h"
#include "scene_lights.h"

#include <candela/default_lights.h>
#include <candela/error.h>
#include <candela/image_file.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace {

constexpr const char* form = "expected FILE.hdr, FILE.exr, studio, sky or none, and [,DEGREES[,STOPS]]";
constexpr double maxDegrees = 1.0e6, maxStops = 64.0;
constexpr std::array words{std::pair{"studio", EnvironmentOption::Source::studio},
                           std::pair{"sky", EnvironmentOption::Source::sky},
                           std::pair{"none", EnvironmentOption::Source::none}};

/// Of a studio that was not asked for, a surface farther away than this share of the scene's size hides
/// nothing: the inside of a closed room is lit too.
constexpr float occlusionShare = 0.1f;

constexpr const char* addedNote =
    "the scene has no light of its own: a studio lights it (--environment none leaves it out)";

std::string shortest(double number) {
    std::array<char, 64> buffer;
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    return std::string(buffer.data(), end);
}

bool isNumber(const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size();
}

EnvironmentLight fromFile(const std::string& path, candela::Strictness strictness) {
    candela::HdrFile file = candela::readHdrFile(path);
    if (strictness == candela::Strictness::strict && !file.notes.empty())
        throw candela::Error(candela::ErrorKind::badInput, "", file.notes.front());
    EnvironmentLight light;
    light.environment = candela::Environment{};
    light.environment->picture = std::move(file.image);
    light.name = path;
    light.notes = std::move(file.notes);
    light.sun = candela::takeSun(*light.environment);
    return light;
}

EnvironmentLight fromSky() {
    candela::Sky sky = candela::skyEnvironment();
    return {std::move(sky.environment), sky.sun, "sky", {}};
}

EnvironmentLight addedStudio(const candela::Scene& scene) {
    EnvironmentLight light{candela::studioEnvironment(), {}, "studio", {addedNote}};
    const candela::Bounds box = sceneBounds(scene, 0.0);
    const float size = box.empty() ? 0.0f : glm::distance(box.min, box.max);
    if (size > 0.0f) light.environment->occlusionDistance = occlusionShare * size;
    return light;
}

EnvironmentLight ofScene(const candela::Scene& scene) {
    EnvironmentLight light{scene.environment, {}, "scene", {}};
    light.sun = candela::takeSun(*light.environment);
    return light;
}

}  // namespace

EnvironmentLight loadEnvironment(const candela::Scene& scene, const SceneOptions& options) {
    using enum EnvironmentOption::Source;
    switch (options.environment.source) {
        case file:
            return fromFile(options.environment.file, options.strictness);
        case studio:
            return {candela::studioEnvironment(), {}, "studio", {}};
        case sky:
            return fromSky();
        case none:
            return {};
        default:
            if (scene.environment) return ofScene(scene);
            return candela::hasLight(scene) ? EnvironmentLight{} : addedStudio(scene);
    }
}

EnvironmentLight placedEnvironment(EnvironmentLight loaded, const SceneOptions& options) {
    if (!loaded.environment) return loaded;
    candela::Environment& environment = *loaded.environment;
    const glm::quat rotation = candela::rotationAboutUp(options.environment.degrees);
    const auto factor = static_cast<float>(std::exp2(options.environment.stops));
    environment.rotation = glm::normalize(rotation * environment.rotation);
    environment.intensity *= factor;
    environment.isBackground = options.background.value_or(environment.isBackground);
    if (loaded.sun) {
        loaded.sun->direction = glm::normalize(rotation * loaded.sun->direction);
        loaded.sun->intensity *= factor;
    }
    return loaded;
}

EnvironmentOption parseEnvironment(const std::string& text) {
    using enum EnvironmentOption::Source;
    const std::string option = "--environment";
    // The name of a file may have commas too.
    std::string name = text;
    std::vector<std::string> numbers;
    while (numbers.size() < 2 && !isEnvironmentFile(name)) {
        const std::size_t comma = name.rfind(',');
        if (comma == name.npos || !isNumber(name.substr(comma + 1))) break;
        numbers.insert(numbers.begin(), name.substr(comma + 1));
        name.resize(comma);
    }
    EnvironmentOption parsed;
    const auto word = std::ranges::find_if(words, [&](const auto& known) { return name == known.first; });
    if (word != words.end())
        parsed.source = word->second;
    else if (isEnvironmentFile(name))
        parsed.source = file;
    if (parsed.source == own || (parsed.source == none && !numbers.empty()))
        throw UsageError(option + " \"" + text + "\": " + form);
    if (parsed.source == file) parsed.file = name;
    if (!numbers.empty()) parsed.degrees = parseNumberBetween(option, numbers[0], -maxDegrees, maxDegrees);
    if (numbers.size() > 1) parsed.stops = parseNumberBetween(option, numbers[1], -maxStops, maxStops);
    return parsed;
}

std::string toString(const EnvironmentOption& option) {
    std::string text = option.file;
    for (const auto& [word, source] : words) {
        if (option.source == source) text = word;
    }
    if (option.degrees != 0.0 || option.stops != 0.0) text += "," + shortest(option.degrees);
    if (option.stops != 0.0) text += "," + shortest(option.stops);
    return text;
}

std::uint32_t parseEnvironmentRays(const std::string& text) {
    constexpr std::int64_t most = 4096;
    return static_cast<std::uint32_t>(parseInteger("--environment-rays", text, 1, most));
}

bool isEnvironmentFile(const std::string& file) {
    const auto endsWith = [&](std::string_view ending) {
        return file.size() > ending.size() &&
               std::equal(ending.rbegin(), ending.rend(), file.rbegin(),
                          [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
    };
    return endsWith(".hdr") || endsWith(".exr");
}
