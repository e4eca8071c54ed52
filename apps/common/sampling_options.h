#pragma once

#include <candela/accumulator.h>
#include <candela/sampling.h>

#include <cstdint>
#include <optional>

namespace CLI {
class App;
}

/// The options of the samples of a picture.
struct SamplingOptions {
    std::optional<std::uint32_t> count;  ///< None: the program's default.
    std::optional<float> fNumber;        ///< Of the lens; none: a pinhole.
    std::optional<float> focusDistance;  ///< Metres; with `fNumber`.
    std::uint32_t blades = 0;
    double shutter = 0.0;           ///< Share of a frame.
    double framesPerSecond = 24.0;  ///< Of --frames and of the shutter.

    /// The settings of the library; `defaultCount` where the options have no count.
    candela::SamplingSettings settings(std::uint32_t defaultCount) const;
};

/// Declares the options, which fill `options` while the command line is parsed. `defaultCount` is told in
/// --help. `options` has to outlive `app`.
void declareSampling(CLI::App& app, SamplingOptions& options, std::uint32_t defaultCount);

/// Declares --point-size and --line-width, pixels. Both numbers have to outlive `app`.
void declareElementSizes(CLI::App& app, float& pointSize, float& lineWidth);

/// Checks options that depend on each other, after parsing. Throws `UsageError`.
void finishSampling(const CLI::App& app, const SamplingOptions& options);
