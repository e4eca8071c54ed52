#pragma once

#include "program.h"

#include <candela/brdf.h>
#include <candela/gpu_scene.h>
#include <candela/renderer.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Strict parsers of option values: the whole text has to be the value. Each throws `UsageError` that names
/// `option`, `text`, and what is expected.

/// The parts between commas; empty parts are kept.
std::vector<std::string> splitAtCommas(std::string_view text);

/// A decimal integer of `min` to `max`.
std::int64_t parseInteger(std::string_view option, std::string_view text, std::int64_t min, std::int64_t max);

/// A finite decimal number.
double parseNumber(std::string_view option, std::string_view text);

/// A finite decimal number that lies between `min` and `max`, both excluded.
double parseNumberBetween(std::string_view option, std::string_view text, double min, double max);

/// "X,Y,Z", finite numbers.
glm::dvec3 parsePoint(std::string_view option, std::string_view text);

/// "WIDTHxHEIGHT", each from 1 to 65536.
std::pair<int, int> parseSize(const std::string& text);

/// A number of threads, 0 (as many as the process may use) to `candela::maxThreadCount`.
unsigned parseThreads(const std::string& text);

candela::VertexEvaluator parseVertexEvaluator(const std::string& text);
candela::TileBackend parseTileBackend(const std::string& text);
candela::Technique parseTechnique(const std::string& text);
candela::BrdfModel parseBrdf(const std::string& text);
/// "on" or "off". Throws `candela::Error` (environment) for "on" where the library has no shadows.
candela::Shadows parseShadows(const std::string& text);

/// True for "on", false for "off".
bool parseOnOff(const std::string& option, const std::string& text);

/// Throws `UsageError` that lists the words that `option` takes, and says which of them `text` was probably
/// meant to be.
[[noreturn]] void throwUnknownWord(const std::string& option, const std::string& text,
                                   const std::vector<std::string>& words);

/// The one of `values` whose name is `text`. Throws `UsageError` that lists all names, after those in `more`,
/// which the caller handles itself.
template <typename Values, typename Name>
auto parseWord(const std::string& option, const std::string& text, const Values& values, Name&& name,
               std::string more = "") -> std::decay_t<decltype(*std::begin(values))> {
    std::vector<std::string> words = splitAtCommas(more);
    for (std::string& word : words) word.erase(0, word.find_first_not_of(' '));
    if (more.empty()) words.clear();
    for (const auto value : values) {
        if (text == name(value)) return value;
        words.emplace_back(name(value));
    }
    throwUnknownWord(option, text, words);
}
