#pragma once

#include "base/runs.h"

#include <candela/error.h>

#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace candela {

/// A number as errors show it.
std::string shortNumber(double value);

/// Whether a number, or each component of a GLM vector or matrix, is finite.
template <typename Value>
bool allFinite(const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) {
        return std::isfinite(value);
    } else {
        for (glm::length_t i = 0; i < value.length(); ++i) {
            if (!allFinite(value[i])) return false;
        }
        return true;
    }
}

/// What a check looks at, as errors name it: an element of a scene ("mesh 3 'wheel'") or an argument
/// ("view"). Its checks throw `Error` (badInput) with the text "LABEL: REASON". It refers to the name it is
/// given, and costs nothing until a check fails.
class ErrorContext {
  public:
    /// Without an index the label is "mesh 'wheel'", without a name as well "mesh".
    ErrorContext(const char* kind, std::optional<std::size_t> index = {}, std::string_view name = {})
        : kind_(kind), index_(index), name_(name) {}

    /// Control characters of the name become '?', and a long name is cut: an error is one line.
    std::string label() const;

    [[noreturn]] void refuse(const std::string& reason, ErrorKind kind = ErrorKind::badInput) const;

    /// Refuses with the text of `rule` unless it holds.
    void require(bool holds, const char* rule) const {
        if (!holds) refuse(rule);
    }

    /// Refuses a number, vector or matrix that is not finite: "WHAT must be finite".
    template <typename Value>
    void requireFinite(const char* what, const Value& value) const {
        if (!allFinite(value)) refuse(std::string(what) + " must be finite");
    }

    /// Refuses unless `value` is finite and over 0.
    void requirePositive(const char* what, double value) const;

    /// Refuses unless `value` is finite and 0 or more.
    void requireNotNegative(const char* what, double value) const;

    /// Refuses unless min <= value <= max, which a NaN never is.
    void requireWithin(const char* what, double value, double min, double max) const;

    /// Refuses an index beyond the `count` elements of `kind` that the scene has.
    void requireIndex(const char* kind, std::optional<std::uint32_t> index, std::size_t count) const;

    /// Refuses unless there are `expected` of `what`, one for each of `of`: "has 3 normals for 4 vertices".
    void requireCount(const char* what, std::uint64_t actual, const char* of, std::uint64_t expected) const;

    /// Refuses with "WHAT INDEX RULE" the first value for which `holds` is false, which is asked on all
    /// cores.
    template <typename Values, typename Rule>
    void requireEach(const char* what, const Values& values, const char* rule, const Rule& holds) const {
        if (holdsForAll(values, holds)) return;
        const auto broken = std::find_if_not(values.begin(), values.end(), holds);
        refuse(what + (" " + std::to_string(broken - values.begin())) + " " + rule);
    }

    /// Refuses the first number, vector or matrix that is not finite.
    template <typename Values>
    void requireEachFinite(const char* what, const Values& values) const {
        requireEach(what, values, "is not a finite number",
                    [](const auto& value) { return allFinite(value); });
    }

  private:
    const char* kind_;
    std::optional<std::size_t> index_;
    std::string_view name_;
};

}  // namespace candela
