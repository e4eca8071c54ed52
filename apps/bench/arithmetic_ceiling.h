#pragma once

#include <candela/brdf.h>
#include <candela/context.h>

#include <optional>
#include <string>

/// How many pairs of pixel and light the device's compute shaders shade at most: they run the light equation
/// of the library (shaders/shared/shading.h) on values in registers, and read and write nothing else.
struct Ceiling {
    double pairsPerSecond = 0.0;       ///< The median of several runs.
    std::optional<std::string> error;  ///< Why it could not be measured; the other member is then 0.
};

/// A line for the user.
std::string ceilingText(const Ceiling& ceiling);

/// For one reflection model. Takes less than a second.
Ceiling measureCeiling(const candela::Context& context, candela::BrdfModel model);
