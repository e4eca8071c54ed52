#include "import/plugin_rules.h"

#include "import/text.h"

#include <algorithm>
#include <cstring>

namespace candela {

namespace {

constexpr std::size_t maxNameBytes = 64;
constexpr std::size_t maxLineBytes = 256;

bool isNameCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

}  // namespace

std::string boundedText(const char* text, std::size_t maxBytes, const std::string& what) {
    if (!text) throw BrokenRule{what + " is NULL"};
    const std::size_t length = ::strnlen(text, maxBytes + 1);
    if (length > maxBytes) throw BrokenRule{joined(what, " is longer than ", maxBytes, " bytes")};
    return std::string(text, length);
}

std::string checkedName(const char* text, const std::string& what) {
    const std::string name = boundedText(text, maxNameBytes, what);
    if (!name.empty() && std::ranges::all_of(name, isNameCharacter)) return name;
    throw BrokenRule{joined(what, " '", oneLine(name), "' is not made of a to z, 0 to 9, '-' and '_' alone")};
}

std::string checkedLine(const char* text, const std::string& what) {
    const std::string line = boundedText(text, maxLineBytes, what);
    if (oneLine(line) != line) throw BrokenRule{what + " is not one line of UTF-8"};
    return line;
}

}  // namespace candela
