#include "panels/texts.h"

#include <array>
#include <cstdio>

std::string groupedText(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t left = text.size(); left > 3; left -= 3) text.insert(left - 3, ",");
    return text;
}

std::string bytesText(std::uint64_t bytes) {
    if (bytes < 1024) return std::to_string(bytes) + " B";
    constexpr std::array units{"KiB", "MiB", "GiB", "TiB"};
    double size = static_cast<double>(bytes) / 1024.0;
    std::size_t unit = 0;
    for (; size >= 1024.0 && unit + 1 < units.size(); ++unit) size /= 1024.0;
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.1f %s", size, units[unit]);
    return text.data();
}

std::string elementText(const char* kind, std::uint64_t index, const std::string& name) {
    return std::string(kind) + " " + std::to_string(index) + (name.empty() ? "" : " " + name);
}

std::string withEnding(const std::string& path, const std::string& ending) {
    return path.ends_with(ending) ? path : path + ending;
}
