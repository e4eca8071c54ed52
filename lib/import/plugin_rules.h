#pragma once

#include <cstddef>
#include <string>

namespace candela {

// The rules of plugin.h for the texts of a description.

/// What is wrong with a description.
struct BrokenRule {
    std::string text;
};

/// Reads at most one byte more than is allowed, so that a string without an end is not read far. `what` is
/// such as "its name". Throws `BrokenRule` for NULL and what is longer.
std::string boundedText(const char* text, std::size_t maxBytes, const std::string& what);

/// A name of a to z, 0 to 9, '-' and '_', of 1 to 64 bytes.
std::string checkedName(const char* text, const std::string& what);

/// One line of UTF-8 of at most 256 bytes.
std::string checkedLine(const char* text, const std::string& what);

}  // namespace candela
