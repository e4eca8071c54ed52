#pragma once

#include "options.h"
#include "picture_plan.h"

#include "common/program.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

/// A picture that has been written, and what it took.
struct PictureResult {
    PlannedPicture picture;
    std::string camera;
    double drawMilliseconds = 0.0;
    double encodeMilliseconds = 0.0;  ///< Writing included.
    std::uint64_t bytes = 0;
};

/// What a run says of its pictures on standard error: one line that changes, on a terminal, or an object a
/// line with --progress json. Every function may be called on any thread.
class RunReport {
  public:
    explicit RunReport(const Options& options);

    /// A note to the user, unless --quiet.
    void note(const std::string& text);
    /// What is being done.
    void work(const std::string& text);
    /// Erases the line of `work`.
    void clear();

    /// The number of pictures that the run is to draw.
    void begin(std::uint64_t count);
    /// That sample `sample` of `samples` of a picture is drawn now.
    void drawing(const PlannedPicture& picture, std::uint32_t sample, std::uint32_t samples);
    void written(const PictureResult& result);
    void skipped(const PlannedPicture& picture, const std::string& reason);
    /// Says it also with --quiet.
    void failed(const PlannedPicture& picture, const std::string& error);
    /// Says it also with --quiet.
    void interrupted(int signal);
    void end();

    /// Sorted by `PlannedPicture::index`. Call when no picture is being encoded.
    std::vector<PictureResult> results() const;
    std::uint64_t skippedCount() const;
    /// The names of pictures that failed, in the order of their failures.
    std::vector<std::string> failures() const;
    double seconds() const;

  private:
    void print(nlohmann::ordered_json event);
    void say(const std::string& line);

    const Options& options_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    mutable std::mutex mutex_;
    Progress progress_;
    std::uint64_t count_ = 0;
    std::vector<PictureResult> results_;
    std::uint64_t skipped_ = 0;
    std::vector<std::string> failures_;
    std::chrono::steady_clock::time_point lastSample_{};
};
