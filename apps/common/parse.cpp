#include "parse.h"

#include <candela/error.h>
#include <candela/nearest_name.h>
#include <candela/threads.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace {

[[noreturn]] void reject(std::string_view option, std::string_view text, const std::string& expected) {
    throw UsageError(std::string(option) + " \"" + std::string(text) + "\": expected " + expected);
}

/// The whole text as a number; none where anything else is in it.
template <typename Number>
std::optional<Number> read(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<double> readFinite(std::string_view text) {
    const std::optional<double> value = read<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

/// A number in its shortest form.
std::string plain(double value) {
    char text[32];
    const auto [end, error] = std::to_chars(text, text + sizeof text, value);
    return {text, error == std::errc{} ? end : text};
}

}  // namespace

std::vector<std::string> splitAtCommas(std::string_view text) {
    std::vector<std::string> parts;
    for (std::size_t comma = text.find(','); comma != text.npos; comma = text.find(',')) {
        parts.emplace_back(text.substr(0, comma));
        text.remove_prefix(comma + 1);
    }
    parts.emplace_back(text);
    return parts;
}

std::int64_t parseInteger(std::string_view option, std::string_view text, std::int64_t min,
                          std::int64_t max) {
    const std::optional<std::int64_t> value = read<std::int64_t>(text);
    if (!value || *value < min || *value > max)
        reject(option, text, "a whole number from " + std::to_string(min) + " to " + std::to_string(max));
    return *value;
}

double parseNumber(std::string_view option, std::string_view text) {
    const std::optional<double> value = readFinite(text);
    if (!value) reject(option, text, "a number");
    return *value;
}

double parseNumberBetween(std::string_view option, std::string_view text, double min, double max) {
    const std::optional<double> value = readFinite(text);
    if (!value || *value <= min || *value >= max)
        reject(option, text, "a number between " + plain(min) + " and " + plain(max));
    return *value;
}

glm::dvec3 parsePoint(std::string_view option, std::string_view text) {
    const std::vector<std::string> parts = splitAtCommas(text);
    glm::dvec3 point{0.0};
    if (parts.size() != 3) reject(option, text, "three numbers X,Y,Z");
    for (int axis = 0; axis < 3; ++axis) {
        const std::optional<double> value = readFinite(parts[static_cast<std::size_t>(axis)]);
        if (!value || std::abs(*value) > 1.0e15)
            reject(option, text, "three numbers X,Y,Z of at most 1e15 metres");
        point[axis] = *value;
    }
    return point;
}

std::pair<int, int> parseSize(const std::string& text) {
    constexpr int maxSide = 65536;
    const std::size_t cross = text.find('x');
    if (cross == text.npos)
        throw UsageError("--size \"" + text + "\": expected WIDTHxHEIGHT, such as 1280x720");
    return {static_cast<int>(parseInteger("--size", text.substr(0, cross), 1, maxSide)),
            static_cast<int>(parseInteger("--size", text.substr(cross + 1), 1, maxSide))};
}

unsigned parseThreads(const std::string& text) {
    return static_cast<unsigned>(parseInteger("--threads", text, 0, candela::maxThreadCount));
}

candela::VertexEvaluator parseVertexEvaluator(const std::string& text) {
    using enum candela::VertexEvaluator;
    return parseWord("--subdivision-evaluator", text, std::array{automatic, cpu, compute},
                     [](candela::VertexEvaluator evaluator) { return candela::toString(evaluator); });
}

candela::TileBackend parseTileBackend(const std::string& text) {
    using enum candela::TileBackend;
    return parseWord("--tiles", text, std::array{automatic, cpu, compute},
                     [](candela::TileBackend backend) { return candela::toString(backend); });
}

candela::Technique parseTechnique(const std::string& text) {
    using enum candela::Technique;
    return parseWord("--technique", text, std::array{automatic, volumes, tiles, fullscreen},
                     [](candela::Technique technique) { return candela::toString(technique); });
}

candela::BrdfModel parseBrdf(const std::string& text) {
    using enum candela::BrdfModel;
    return parseWord("--brdf", text, std::array{course, gltf},
                     [](candela::BrdfModel model) { return candela::toString(model); });
}

void throwUnknownWord(const std::string& option, const std::string& text,
                      const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    throw UsageError(option + " \"" + text + "\": expected one of " + list +
                     candela::didYouMean(text, words));
}

bool parseOnOff(const std::string& option, const std::string& text) {
    return parseWord(option, text, std::array{true, false}, [](bool on) { return on ? "on" : "off"; });
}

candela::Shadows parseShadows(const std::string& text) {
    using enum candela::Shadows;
    const candela::Shadows shadows = parseWord("--shadows", text, std::array{on, off},
                                               [](candela::Shadows word) { return candela::toString(word); });
    if (shadows == on && !candela::hasShadows()) {
        throw candela::Error(candela::ErrorKind::environment, "--shadows on",
                             "this candela is built without shadows (the CMake option CANDELA_SHADOWS, which "
                             "needs Embree)");
    }
    return shadows;
}
