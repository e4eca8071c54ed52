#include "deferred_signals.h"

#include <array>
#include <csignal>

namespace {

constexpr std::array interrupts{SIGINT, SIGTERM, SIGHUP};

std::array<struct sigaction, interrupts.size()> previous;
volatile std::sig_atomic_t waiting = 0;

void remember(int signal) {
    waiting = signal;
}

}  // namespace

DeferredSignals::DeferredSignals() {
    waiting = 0;
    struct sigaction later {};
    later.sa_handler = remember;
    sigemptyset(&later.sa_mask);
    later.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < interrupts.size(); ++i) {
        sigaction(interrupts[i], nullptr, &previous[i]);
        // A signal that the parent process had ignored (nohup) stays ignored.
        if (previous[i].sa_handler != SIG_IGN) sigaction(interrupts[i], &later, nullptr);
    }
}

DeferredSignals::~DeferredSignals() {
    for (std::size_t i = 0; i < interrupts.size(); ++i) sigaction(interrupts[i], &previous[i], nullptr);
    if (waiting != 0) std::raise(waiting);
}
