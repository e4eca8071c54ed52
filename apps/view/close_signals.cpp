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
/// An eventfd, to which the signal handler writes; few other calls are safe in it.
int wakeDescriptor = -1;

void notify() {
    constexpr std::uint64_t one = 1;
    // It can only fail after 2^64 notifications.
    [[maybe_unused]] const ssize_t written = write(wakeDescriptor, &one, sizeof one);
}

void askToClose(int) {
    const int error = errno;
    notify();
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
    wakeDescriptor = eventfd(0, EFD_CLOEXEC);
    if (wakeDescriptor < 0)
        throw candela::Error(candela::ErrorKind::environment, "",
                             std::string("cannot create an eventfd: ") + std::strerror(errno));
    thread_ = std::thread([this] { wait(); });
    install();
}

CloseSignals::~CloseSignals() {
    for (std::size_t i = 0; i < interrupts.size(); ++i) sigaction(interrupts[i], &previous[i], nullptr);
    stopping_ = true;
    notify();
    thread_.join();
    close(wakeDescriptor);
}

void CloseSignals::wait() {
    for (;;) {
        std::uint64_t count = 0;
        if (read(wakeDescriptor, &count, sizeof count) < 0 && errno == EINTR) continue;
        if (stopping_) return;
        raised_ = true;
        wake_();
    }
}
