#include "progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <iostream>

namespace {

/// Where the line has to end so that the terminal does not wrap it.
std::size_t terminalWidth() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 2) return 79;
    return size.ws_col - 1u;
}

constexpr const char* eraseLine = "\r\x1b[K";

}  // namespace

Progress::Progress(Verbosity verbosity)
    : enabled_(verbosity == Verbosity::normal && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    clear();
}

void Progress::show(const std::string& text) {
    if (!enabled_ || text == shown_) return;
    shown_ = text;
    std::cerr << eraseLine << text.substr(0, terminalWidth()) << std::flush;
}

void Progress::clear() {
    if (shown_.empty()) return;
    shown_.clear();
    std::cerr << eraseLine << std::flush;
}
