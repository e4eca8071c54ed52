#pragma once

#include "bench_options.h"
#include "bench_scene.h"
#include "pass_clock.h"
#include "results.h"

#include <memory>
#include <string>
#include <vector>

/// A program that draws the scene of its construction: candela, or one it is compared with.
class Program {
  public:
    virtual ~Program() = default;

    /// Draws a frame, waits for its end, and says what it took.
    virtual FrameTimes draw() = 0;
    /// Fills in what was counted, outside of timed frames.
    virtual void count(Result& result) = 0;
    /// The last frame's radiance, RGB, for comparing pictures. Empty for a program that makes none.
    virtual std::vector<float> picture() = 0;
};

/// Draws the program's frames and takes medians: after one frame that is not counted, as many frames as the
/// options say, but at most ten seconds long when they are three or more, and never over a minute.
/// With a `baseline`, which draws the scene's first `referenceLights` lights, the two take turns, so that
/// what else the machine does falls on both; the lighting time of the baseline is the result's `reference`.
Result measure(Program& program, Program* baseline, const BenchScene& scene, const BenchOptions& options,
               const std::string& technique);

/// Milliseconds that a plain copy of the lights' array takes: what rejecting them all is compared with.
double measureCopy(const std::vector<candela::WorldLight>& lights);
