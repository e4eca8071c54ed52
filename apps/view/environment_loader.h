#pragma once

#include "common/scene_environment.h"

#include <future>
#include <optional>
#include <string>
#include <thread>

/// Reads the pictures of environments on a thread of its own, one at a time.
class EnvironmentLoader {
  public:
    EnvironmentLoader() = default;
    EnvironmentLoader(const EnvironmentLoader&) = delete;
    EnvironmentLoader& operator=(const EnvironmentLoader&) = delete;
    /// Waits.
    ~EnvironmentLoader();

    /// What came of it.
    struct Result {
        std::string file;
        EnvironmentLight light;  ///< As `loadEnvironment` returns it.
        std::string error;       ///< Where it could not be read.
    };

    /// Begins to read `file`, at once or when what is being read has ended, whose result is dropped then.
    /// `wake` is called from the thread when there is a result.
    void start(const std::string& file, candela::Strictness strictness, void (*wake)());
    /// The file that is being read; empty where none is.
    const std::string& reading() const { return wanted_.file; }
    /// The result, once, when the reading has ended.
    std::optional<Result> take();

  private:
    struct Request {
        std::string file;
        candela::Strictness strictness = candela::Strictness::tolerant;
        void (*wake)() = nullptr;
    };
    void read();

    Request wanted_;
    std::thread thread_;
    std::future<Result> result_;  ///< Valid while the thread reads.
};
