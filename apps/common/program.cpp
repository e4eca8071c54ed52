#include "program.h"

#include <candela/error.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace {

enum ExitCode { done = 0, inputOrEnvironmentAtFault = 1, wrongUsage = 2 };

/// Prints one line, even where the message of a library has several.
int report(const char* name, std::string text, ExitCode code) {
    std::ranges::replace(text, '\n', ' ');
    std::cerr << name << ": " << text << std::endl;
    return code;
}

/// The number of columns that the terminal shows without wrapping.
std::size_t terminalWidth() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 2) return 79;
    return size.ws_col - 1u;
}

constexpr const char* eraseLine = "\r\x1b[K";

}  // namespace

int runProgram(const char* name, const std::function<void()>& work) {
    // Beyond `ulimit -f` a write fails, and the error says so, instead of ending the process.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        work();
        if (!std::cout.flush())
            throw candela::Error(candela::ErrorKind::environment, "standard output", "cannot be written");
        return done;
    } catch (const UsageError& error) {
        return report(name, std::string(error.what()) + "; --help shows the options", wrongUsage);
    } catch (const std::bad_alloc&) {
        return report(name, "there is not enough memory", inputOrEnvironmentAtFault);
    } catch (const std::exception& error) {
        return report(name, error.what(), inputOrEnvironmentAtFault);
    }
}

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
