#pragma once

#include <candela/context.h>
#include <candela/renderer.h>

#include <epoxy/gl.h>

#include <chrono>
#include <string>
#include <vector>

/// What one frame took, milliseconds.
struct FrameTimes {
    double frame = 0.0;
    std::vector<candela::PassTime> passes;
};

/// Times a frame and its passes: on a GPU by timestamp queries, which do not stall it; on a software
/// rasteriser, which has nothing to overlap with, by the wall clock around a finish.
class PassClock {
  public:
    explicit PassClock(const candela::Context& context);
    PassClock(const PassClock&) = delete;
    PassClock& operator=(const PassClock&) = delete;
    ~PassClock();

    /// The frame begins now.
    void start();
    /// The pass that began at the last mark ends now.
    void lap(const std::string& name);
    /// Waits for the frame's end. The frame is all laps together.
    FrameTimes times();

  private:
    void mark();
    /// Seconds at a mark, from a fixed point in time.
    double at(std::size_t index);

    bool software_;
    std::size_t marks_ = 0;
    std::vector<std::string> names_;
    std::vector<GLuint> queries_;
    std::vector<std::chrono::steady_clock::time_point> walls_;
};
