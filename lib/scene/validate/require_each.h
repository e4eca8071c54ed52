#pragma once

#include "scene/validate/error_context.h"
#include "scene/validate/finite.h"

#include <algorithm>
#include <string>
#include <vector>

namespace candela {

/// Refuses with "WHAT INDEX RULE" the first value for which `holds` is false.
template <typename Value, typename Rule>
void requireEach(const std::vector<Value>& values, const char* what, const char* rule,
                 const ErrorContext& element, Rule holds) {
    const auto broken = std::find_if_not(values.begin(), values.end(), holds);
    if (broken == values.end()) return;
    element.refuse(what + (" " + std::to_string(broken - values.begin())) + " " + rule);
}

/// Refuses GLM vectors of which a number is not finite.
template <typename Value>
void requireFinite(const std::vector<Value>& values, const char* what, const ErrorContext& element) {
    requireEach(values, what, "is not a finite number", element,
                [](const Value& value) { return allFinite(value); });
}

}  // namespace candela
