#pragma once

#include "bench_scene.h"
#include "results.h"

#include <string>
#include <vector>

/// A picture to compare the others of its scene with.
struct Reference {
    std::string technique;
    std::vector<float> picture;
};

/// How far a picture of `technique` may differ from the reference: the mean difference as a share of the
/// reference's mean.
///  - candela's techniques differ in the order of sums and in roundings only: 1e-5.
///  - The textbook programs keep colours in 8 linear bits and add up in half floats: 0.02. They keep
///  positions
///    in half floats, whose rounding r (0.016 m an axis from 32 m to 64 m) changes the inverse square at half
///    a light's range by up to 4 sqrt(3) r / range: that much more, for the shortest range.
double allowedDifference(const std::string& technique, const BenchScene& scene);

/// Writes the difference into `result` and throws `candela::Error` (badInput) when it is more than `allowed`.
void compare(Result& result, const std::vector<float>& picture, const Reference& reference, double allowed);
