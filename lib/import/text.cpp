#include "import/text.h"

#include <algorithm>
#include <cstdint>

namespace candela {
namespace {

bool isBetween(unsigned char byte, unsigned low, unsigned high) {
    return byte >= low && byte <= high;
}

// The length of the well-formed UTF-8 sequence that `text` begins with, 0 when there is none. The second byte
// has a narrower range after some first bytes: that excludes overlong forms, surrogates and what is beyond
// U+10FFFF.
std::size_t sequenceLength(std::string_view text) {
    const auto byteAt = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0);
    };
    const auto isTail = [&](std::size_t i) { return isBetween(byteAt(i), 0x80, 0xBF); };
    const unsigned char first = byteAt(0), second = byteAt(1);
    if (first < 0x80) return 1;
    if (isBetween(first, 0xC2, 0xDF)) return isTail(1) ? 2 : 0;
    if (isBetween(first, 0xE0, 0xEF)) {
        const unsigned low = first == 0xE0 ? 0xA0 : 0x80, high = first == 0xED ? 0x9F : 0xBF;
        return isBetween(second, low, high) && isTail(2) ? 3 : 0;
    }
    if (isBetween(first, 0xF0, 0xF4)) {
        const unsigned low = first == 0xF0 ? 0x90 : 0x80, high = first == 0xF4 ? 0x8F : 0xBF;
        return isBetween(second, low, high) && isTail(2) && isTail(3) ? 4 : 0;
    }
    return 0;
}

bool isControl(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
}

}  // namespace

std::string validUtf8(const char* text) {
    return text ? validUtf8(std::string_view(text)) : std::string();
}

std::string validUtf8(std::string_view text) {
    std::string valid;
    valid.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = sequenceLength(text);
        if (length == 0)
            valid += "\uFFFD";
        else
            valid += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return valid;
}

std::string oneLine(std::string_view text, std::size_t maxBytes) {
    std::string line = validUtf8(text.substr(0, maxBytes));
    // Cutting inside a sequence leaves up to three bytes, which validUtf8 has replaced.
    if (text.size() > maxBytes) line += "...";
    std::replace_if(line.begin(), line.end(), isControl, ' ');
    return line;
}

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

}  // namespace candela
