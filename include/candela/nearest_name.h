#pragma once

#include <candela/export.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace candela {

/// The name that `text` was probably meant to be: one that begins with it, or the nearest one by the number
/// of letters that are added, left out, replaced or swapped with the next. None where that is more than a
/// third of the letters of `text` (at least one). Upper and lower case count as the same letter.
CANDELA_API std::optional<std::string> nearestName(std::string_view text, std::span<const std::string> names);

/// " (did you mean NAME?)" for the end of an error, empty where there is no such name.
CANDELA_API std::string didYouMean(std::string_view text, std::span<const std::string> names);

}  // namespace candela
