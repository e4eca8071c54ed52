#pragma once

/// While one lives, an interrupt (SIGINT, SIGTERM, SIGHUP) waits: a file that is being written is finished or
/// not there, and nothing is left beside it. The signal then takes effect at the end of the scope.
class DeferredSignals {
  public:
    DeferredSignals();
    DeferredSignals(const DeferredSignals&) = delete;
    DeferredSignals& operator=(const DeferredSignals&) = delete;
    ~DeferredSignals();
};
