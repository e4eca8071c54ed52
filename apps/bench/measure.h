#pragma once

#include "bench_options.h"
#include "bench_scene.h"
#include "results.h"

#include <chrono>
#include <functional>
#include <string>
#include <vector>

/// A program that draws the scene of its construction: candela, or one it is compared with.
class Program {
  public:
    virtual ~Program() = default;

    /// Draws a frame and waits for its end. Returns the time of each pass, in milliseconds, where it knows
    /// them.
    virtual std::vector<candela::PassTime> draw() = 0;
    /// Fills in what was counted, outside of timed frames.
    virtual void count(Result& result) = 0;
    /// The last frame's radiance, RGB, for comparing pictures. Empty for a program that makes none.
    virtual std::vector<float> picture() = 0;
};

/// Draws the program's frames and takes medians: after one frame that is not counted, `frames` frames, or as
/// many as ten seconds allow.
Result measure(Program& program, const BenchScene& scene, const BenchOptions& options,
               const std::string& technique);
