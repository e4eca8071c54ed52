#include "close_signals.h"

#include <candela/error.h>

#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>

namespace {

constexpr std::array interrupts{SIGINT, SIGTERM, SIGHUP};

std::array<struct sigaction, interrupts.size()> previous;
int bell = -1;  ///< An eventfd: a handler may do little more than write to it.

void ring() {
    constexpr std::uint64_t one = 1;
    // It can only fail when it has been rung 2^64 times.
    [[maybe_unused]] const ssize_t written = write(bell, &one, sizeof one);
}

void askToClose(int) {
    const int error = errno;
    ring();
    errno = error;
}

void install() {
    struct sigaction asking {};
    asking.sa_handler = askToClose;
    sigemptyset(&asking.sa_mask);
    asking.sa_flags = SA_RESTART | SA_RESETHAND;
    for (std::size_t i = 0; i < interrupts.size(); ++i) {
        sigaction(interrupts[i], nullptr, &previous[i]);
        // A signal that the parent process had ignored (nohup) stays ignored.
        if (previous[i].sa_handler != SIG_IGN) sigaction(interrupts[i], &asking, nullptr);
    }
}

}  // namespace

CloseSignals::CloseSignals(void (*wake)()) : wake_(wake) {
    bell = eventfd(0, EFD_CLOEXEC);
    if (bell < 0)
        throw candela::Error(candela::ErrorKind::environment, "",
                             std::string("no eventfd can be made: ") + std::strerror(errno));
    thread_ = std::thread([this] { wait(); });
    install();
}

CloseSignals::~CloseSignals() {
    for (std::size_t i = 0; i < interrupts.size(); ++i) sigaction(interrupts[i], &previous[i], nullptr);
    stopping_ = true;
    ring();
    thread_.join();
    close(bell);
}

void CloseSignals::wait() {
    for (;;) {
        std::uint64_t rings = 0;
        if (read(bell, &rings, sizeof rings) < 0 && errno == EINTR) continue;
        if (stopping_) return;
        raised_ = true;
        wake_();
    }
}
