#include "count.h"

#include "generator.h"

namespace plaza {
namespace {

constexpr std::uint32_t maxCount = 16'000'000;

bool isInRange(const std::string& digits, std::uint32_t& count) {
    if (digits.empty()) return false;
    std::uint64_t value = 0;
    for (const char c : digits) {
        if (c < '0' || c > '9') return false;
        value = value * 10 + static_cast<std::uint64_t>(c - '0');
        if (value > maxCount) return false;
    }
    count = static_cast<std::uint32_t>(value);
    return true;
}

}  // namespace

std::uint32_t parseCount(const std::string& text, const std::string& element, const std::string& example) {
    std::uint32_t count = 0;
    if (!isInRange(text, count))
        throw BadRequest(element, "'" + text + "' is not a whole number from 0 to " +
                                      std::to_string(maxCount) + ", as in " + example);
    return count;
}

}  // namespace plaza
