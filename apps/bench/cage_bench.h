#pragma once

#include "bench_options.h"

#include <candela/context.h>
#include <candela/plugin_registry.h>

#include <cstdint>
#include <string>

/// The measurements of a moving cage. Times are medians in milliseconds; compared variants are measured
/// alternately.
struct CageResult {
    std::uint64_t quads = 0, vertices = 0, entries = 0;  ///< Of the cage; of its table.
    std::uint32_t level = 0;
    std::string evaluator;          ///< What candela used: "cpu" or "compute".
    double move = 0.0;              ///< From new points to vertices with normals on the device.
    double opensubdivMove = 0.0;    ///< Osd::OmpEvaluator over the same table.
    double refine = 0.0;            ///< `Subdivider::refine`, with the checks and copies of the host.
    double opensubdivRefine = 0.0;  ///< Far's refiner and limit stencils.
};

/// --scene cages. Throws `candela::Error` when no plugin refines cages, or when the positions of candela and
/// OpenSubdiv for the same points differ by more than rounding.
CageResult measureCages(const candela::PluginRegistry& plugins, const candela::Context& context,
                        const BenchOptions& options);

/// {"renderer", "setup", "results": [one row]}.
std::string cageResultJson(const std::string& renderer, const std::string& setup, const CageResult& result);
std::string cageResultTable(const CageResult& result);
