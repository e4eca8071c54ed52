#pragma once

#include "bench_options.h"

#include <string>

/// What the results were measured with, as a JSON object: {"version", "cpu", "cores", "system", "opengl",
/// "brdf", "view"}. Needs a current context.
std::string setupJson(const BenchOptions& options);
