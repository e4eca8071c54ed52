#pragma once

#include "results.h"

#include <string>
#include <vector>

/// Lighting time against the number of lights as an SVG picture, both axes logarithmic, a line a technique.
/// Needs two numbers of lights at least for a line; one gives points.
std::string plotSvg(const std::string& renderer, const std::vector<Result>& results);
