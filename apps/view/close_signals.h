#pragma once

#include <atomic>
#include <thread>

/// While one lives, a first interrupt (SIGINT, SIGTERM, SIGHUP) asks the session to end as if its window were
/// closed; a second one ends the program at once. Waits without using the CPU. One at a time.
class CloseSignals {
  public:
    /// `wake` is called from a thread of its own. Throws `candela::Error` (environment).
    explicit CloseSignals(void (*wake)());
    CloseSignals(const CloseSignals&) = delete;
    CloseSignals& operator=(const CloseSignals&) = delete;
    ~CloseSignals();

    /// Has there been one?
    bool raised() const { return raised_; }

  private:
    void wait();

    void (*wake_)();
    std::atomic<bool> raised_{false}, stopping_{false};
    std::thread thread_;
};
