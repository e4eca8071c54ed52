#pragma once

#include "gl/object.h"

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candela::gl {

void deleteQuery(GLuint name);

/// Names the GL commands of a scope for debuggers and traces.
class DebugGroup {
  public:
    explicit DebugGroup(const char* name);
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
    ~DebugGroup();
};

/// Times the passes of a frame: on a GPU with timestamp queries, which do not stall it; on a software
/// rasteriser, whose queries do not cover its worker threads, by the wall clock around a finish. A pass that
/// runs again before `beginFrame` replaces its time.
class PassTimer {
  public:
    enum class Clock { gpuQueries, wallAroundFinish };

    explicit PassTimer(Clock clock);

    /// Forgets the last frame's passes.
    void beginFrame();

    /// A pass, for as long as the object lives: a debug group and a time.
    class Scope {
      public:
        Scope(PassTimer& timer, const char* name);
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;
        ~Scope();

      private:
        PassTimer& timer_;
        DebugGroup group_;
    };

    /// Name and milliseconds of each pass since `beginFrame`, in order. Waits for them to end.
    std::vector<std::pair<std::string, double>> results();

  private:
    struct Pass {
        std::string_view name;  ///< Of a string literal.
        double milliseconds;
    };
    void begin(const char* name);
    void end();
    GLuint query(std::size_t index);

    Clock clock_;
    std::vector<Pass> passes_;
    std::size_t current_ = 0;  ///< Index into `passes_` of the pass that runs.
    std::chrono::steady_clock::time_point start_;
    std::vector<Object<deleteQuery>> queries_;
};

}  // namespace candela::gl
