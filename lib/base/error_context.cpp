#include "base/error_context.h"

#include <cstdio>

namespace candela {

std::string shortNumber(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string ErrorContext::label() const {
    constexpr std::size_t maxNameLength = 64;
    std::string text = kind_;
    if (index_) text += " " + std::to_string(*index_);
    if (name_.empty()) return text;
    text += " '";
    for (const char c : name_.substr(0, maxNameLength)) {
        const auto byte = static_cast<unsigned char>(c);
        text += byte < 0x20 || byte == 0x7f ? '?' : c;
    }
    return text + (name_.size() > maxNameLength ? "...'" : "'");
}

void ErrorContext::refuse(const std::string& reason, ErrorKind kind) const {
    throw Error(kind, {}, label() + ": " + reason);
}

namespace {

std::string valueText(const char* what, double value) {
    return what + (" is " + shortNumber(value)) + ", but ";
}

}  // namespace

void ErrorContext::requirePositive(const char* what, double value) const {
    if (!std::isfinite(value)) refuse(valueText(what, value) + "a finite number was expected");
    if (value > 0.0) return;
    refuse(valueText(what, value) + "a number over 0 was expected");
}

void ErrorContext::requireNotNegative(const char* what, double value) const {
    if (!std::isfinite(value)) refuse(valueText(what, value) + "a finite number was expected");
    if (value >= 0.0) return;
    refuse(valueText(what, value) + "0 or more was expected");
}

void ErrorContext::requireWithin(const char* what, double value, double min, double max) const {
    if (value >= min && value <= max) return;
    refuse(valueText(what, value) + shortNumber(min) + " to " + shortNumber(max) + " was expected");
}

void ErrorContext::requireIndex(const char* kind, std::optional<std::uint32_t> index,
                                std::size_t count) const {
    if (!index || *index < count) return;
    refuse("refers to " + (kind + (" " + std::to_string(*index))) + ", but the scene has " +
           std::to_string(count) + " (counted from 0)");
}

void ErrorContext::requireCount(const char* what, std::uint64_t actual, const char* of,
                                std::uint64_t expected) const {
    if (actual == expected) return;
    refuse("has " + std::to_string(actual) + " " + what + " for " + std::to_string(expected) + " " + of);
}

}  // namespace candela
