#include "scene/validate/error_context.h"

#include <candela/error.h>

#include <cstdio>

namespace candela {

namespace {

constexpr std::size_t longestName = 64;

}  // namespace

std::string shortNumber(float value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", static_cast<double>(value));
    return text;
}

std::string ErrorContext::label() const {
    std::string text = kind_;
    if (index_) text += " " + std::to_string(*index_);
    if (name_.empty()) return text;
    text += " '";
    for (const char c : name_.substr(0, longestName)) {
        const auto byte = static_cast<unsigned char>(c);
        text += byte < 0x20 || byte == 0x7f ? '?' : c;
    }
    return text + (name_.size() > longestName ? "...'" : "'");
}

void ErrorContext::refuse(const std::string& reason) const {
    throw Error(ErrorKind::badInput, {}, label() + ": " + reason);
}

void ErrorContext::requireWithin(const char* what, float value, float least, float most) const {
    if (value >= least && value <= most) return;
    refuse(what + (" is " + shortNumber(value)) + ", but must lie between " + shortNumber(least) + " and " +
           shortNumber(most));
}

void ErrorContext::requireIndex(const char* kind, std::optional<std::uint32_t> index,
                                std::size_t count) const {
    if (!index || *index < count) return;
    refuse("refers to " + (kind + (" " + std::to_string(*index))) + ", but the scene has " +
           std::to_string(count) + " (counted from 0)");
}

}  // namespace candela
