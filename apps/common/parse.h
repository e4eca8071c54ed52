#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Strict readers of option values: the whole text has to be the value. Each throws `UsageError` that names
/// `option`, shows `text`, and says what is expected.

/// The parts between commas; empty parts are kept.
std::vector<std::string> splitAtCommas(std::string_view text);

/// A decimal integer of `least` to `most`.
std::int64_t parseInteger(std::string_view option, std::string_view text, std::int64_t least,
                          std::int64_t most);

/// A finite decimal number.
double parseNumber(std::string_view option, std::string_view text);

/// A finite decimal number that lies between `least` and `most`, both excluded.
double parseNumberBetween(std::string_view option, std::string_view text, double least, double most);

/// "X,Y,Z", finite numbers.
glm::vec3 parsePoint(std::string_view option, std::string_view text);
