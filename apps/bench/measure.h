#pragma once

#include "bench_options.h"
#include "bench_scene.h"
#include "results.h"

#include <candela/context.h>
#include <candela/renderer.h>

#include <epoxy/gl.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Times of one frame, milliseconds.
struct FrameTimes {
    double frame = 0.0;
    std::vector<candela::PassTime> passes;
};

/// Times a frame and its passes: on a GPU by timestamp queries, which do not stall it; on a software
/// rasteriser, which runs nothing asynchronously, by the wall clock around a glFinish.
class PassClock {
  public:
    explicit PassClock(const candela::Context& context);
    PassClock(const PassClock&) = delete;
    PassClock& operator=(const PassClock&) = delete;
    ~PassClock();

    /// Begins a frame.
    void start();
    /// Ends the pass that began at `start` or at the last `lap`.
    void lap(const std::string& name);
    /// Waits for the frame's end. The frame time is the sum of all laps.
    FrameTimes times();

  private:
    void mark();
    /// Seconds at a mark, from a fixed point in time.
    double at(std::size_t index);

    bool software_;
    std::size_t marks_ = 0;
    std::vector<std::string> names_;
    std::vector<GLuint> queries_;
    std::vector<std::chrono::steady_clock::time_point> wallTimes_;
};

/// A program that draws one scene: candela, or a baseline.
class Program {
  public:
    virtual ~Program() = default;

    /// Draws a frame, waits for its end, and returns its times.
    virtual FrameTimes draw() = 0;
    /// Fills in the counters, outside of timed frames.
    virtual void count(Result& result) = 0;
    /// The last frame's radiance, RGB, rows from the top. Empty for a program that lights nothing.
    virtual std::vector<float> radiance() = 0;
};

/// A program to measure, and what its row says of it.
struct Subject {
    std::string technique;
    std::optional<candela::Shadows> shadows;
    std::uint32_t samples = 1;  ///< A pixel.
    std::unique_ptr<Program> program;
    std::unique_ptr<Program> reference;  ///< Draws the scene's first `referenceLights` lights; or null.
};

/// Draws frames of all subjects and their references alternately, so that other load on the machine affects
/// all, and takes medians: after one frame that is not counted, `options.frames` frames; fewer, but at least
/// three, when they take over ten seconds, and fewer than three over a minute. One result for each subject.
std::vector<Result> measure(const std::vector<Subject>& subjects, const BenchScene& scene,
                            const BenchOptions& options);

/// The radiance that the others of its scene are compared with.
struct ReferenceImage {
    std::string technique;
    std::vector<float> rgb;
};

/// The allowed mean difference of the radiance of `technique` from the reference, as a share of the
/// reference's mean.
///  - candela's techniques differ by the order of sums and by rounding only: 1e-5.
///  - The textbook programs keep colours in 8 linear bits and accumulate in half floats: 0.02. They keep
///    positions in half floats, whose rounding r (0.016 m an axis from 32 m to 64 m) changes the inverse
///    square at half a light's range by up to 4 sqrt(3) r / range: added for the shortest range.
double allowedDifference(const std::string& technique, const BenchScene& scene);

/// Writes the difference into `result`. Sets `result.error` where the radiance has values that are not
/// finite, or differs by more than `allowed`.
void compareImages(Result& result, const std::vector<float>& rgb, const ReferenceImage& reference,
                   double allowed);
