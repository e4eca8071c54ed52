#pragma once

#include "measure.h"

#include <candela/candela.h>

#include <memory>

/// candela itself, with one technique.
std::unique_ptr<Program> makeCandelaProgram(const candela::Context& context, const BenchScene& scene,
                                            const BenchOptions& options, candela::Technique technique);
