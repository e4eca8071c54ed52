#pragma once

#include "measure.h"

#include <memory>

/// A program that only clears, draws the geometry with depth and one RGBA8 target, and reads nothing back:
/// the least that any frame costs.
std::unique_ptr<Program> makeBareBaseline(const candela::Context& context, const BenchScene& scene,
                                          const BenchOptions& options);
