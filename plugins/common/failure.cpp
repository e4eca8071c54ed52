#include "failure.h"

namespace candela_plugins {

std::string readable(const std::string& text) {
    constexpr std::size_t maxBytes = 80;
    std::string line = text;
    if (line.size() > maxBytes) {
        std::size_t end = maxBytes;
        // A cut inside a UTF-8 sequence would make the message unreadable.
        while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0u) == 0x80u) --end;
        line = line.substr(0, end) + "...";
    }
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    }
    return line;
}

std::string elementName(const char* noun, std::size_t index, const std::string& name) {
    std::string text = std::string(noun) + " " + std::to_string(index);
    if (!name.empty()) text += " '" + readable(name) + "'";
    return text;
}

}  // namespace candela_plugins
