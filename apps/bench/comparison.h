#pragma once

#include "results.h"

#include <string>
#include <vector>

/// A picture to compare the others of its scene with.
struct Reference {
    std::string technique;
    std::vector<float> picture;
};

/// How far a picture may differ from the reference: the mean difference as a share of the reference's mean.
///  - candela's techniques differ in the order of sums and in roundings only: 1e-5.
///  - The textbook programs keep positions in half floats, which at 32 to 64 m stand 3 cm apart, and add up
///  in half floats, which lose up to 2^-11
///    of a sum with each light; colours have 8 linear bits: 5e-2.
double allowedDifference(const std::string& technique);

/// Writes the difference into `result` and throws `candela::Error` (badInput) when it is more than allowed.
void compare(Result& result, const std::vector<float>& picture, const Reference& reference);
