#pragma once

/// While one lives, the first SIGINT, SIGTERM or SIGHUP is remembered instead of ending the process; the next
/// one ends it. A signal that the parent process had ignored (nohup) stays ignored. At most one lives at a
/// time.
class Interruption {
  public:
    Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;
    ~Interruption();

    /// The signal that came; 0 without one. May be called on any thread.
    static int signal();
};

/// Thrown by what stops in the middle of a picture since a signal came.
struct Interrupted {};

/// "SIGINT", "SIGTERM" or "SIGHUP".
const char* signalName(int signal);
