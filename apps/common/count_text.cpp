#include "count_text.h"

#include <cstddef>

std::string groupedText(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t left = text.size(); left > 3; left -= 3) text.insert(left - 3, ",");
    return text;
}

std::string countText(std::uint64_t number, const char* one, const char* many) {
    const std::string text = groupedText(number) + " ";
    if (number == 1) return text + one;
    return many ? text + many : text + one + "s";
}
