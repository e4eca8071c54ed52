#pragma once

#include "results.h"

#include <cstdint>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>

// Measurements as the tables show them; "-" stands for what was not measured.

inline std::string fixedText(const std::optional<double>& value, int digits) {
    if (!value) return "-";
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << *value;
    return text.str();
}

inline std::string millionsText(const std::optional<std::uint64_t>& value) {
    return value ? fixedText(static_cast<double>(*value) * 1.0e-6, 2) : "-";
}

/// Millions of lit pairs a second of the lighting pass.
inline std::string rateText(const Result& result) {
    if (!result.pairsLit || !result.lighting || *result.lighting <= 0.0) return "-";
    return fixedText(static_cast<double>(*result.pairsLit) / *result.lighting * 1.0e-3, 1);
}

/// Lit over evaluated pairs, percent.
inline std::string shareText(const Result& result) {
    if (!result.pairsLit || !result.pairsEvaluated || *result.pairsEvaluated == 0) return "-";
    return fixedText(
        100.0 * static_cast<double>(*result.pairsLit) / static_cast<double>(*result.pairsEvaluated), 0);
}
