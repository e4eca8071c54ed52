#pragma once

#include "arithmetic_ceiling.h"
#include "results.h"

#include <optional>
#include <string>
#include <vector>

/// Of the lit pairs of the lighting pass, times 1 over those that the device shades at most; none without
/// pairs, and for a row that no shader has lit.
std::optional<double> ceilingShare(const Result& result, const std::optional<Ceiling>& ceiling);

/// The table of docs/benchmarks.md: a heading line and a row for each result, in Markdown. Without a ceiling
/// its column is left out, and so is that of differences where no pictures were compared. What could not be
/// measured is a line under the table.
std::string markdownTable(const std::vector<Result>& results, const std::optional<Ceiling>& ceiling);
