#include "interruption.h"

#include <array>
#include <atomic>
#include <csignal>

namespace {

constexpr std::array interrupts{SIGINT, SIGTERM, SIGHUP};

std::array<struct sigaction, interrupts.size()> previous;
std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may store into it");

void remember(int signal) {
    received = signal;
}

}  // namespace

Interruption::Interruption() {
    received = 0;
    struct sigaction once {};
    once.sa_handler = remember;
    sigemptyset(&once.sa_mask);
    once.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
    for (std::size_t i = 0; i < interrupts.size(); ++i) {
        sigaction(interrupts[i], nullptr, &previous[i]);
        if (previous[i].sa_handler != SIG_IGN) sigaction(interrupts[i], &once, nullptr);
    }
}

Interruption::~Interruption() {
    for (std::size_t i = 0; i < interrupts.size(); ++i) sigaction(interrupts[i], &previous[i], nullptr);
}

int Interruption::signal() {
    return received;
}

const char* signalName(int signal) {
    if (signal == SIGINT) return "SIGINT";
    return signal == SIGTERM ? "SIGTERM" : "SIGHUP";
}
