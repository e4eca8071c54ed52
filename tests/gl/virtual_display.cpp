#include "virtual_display.h"

#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace candela::test {

VirtualDisplay::VirtualDisplay() {
    if (std::getenv("DISPLAY") != nullptr) return;
    whyNot_ = start();
}

VirtualDisplay::~VirtualDisplay() {
    if (server_ < 0) return;
    unsetenv("DISPLAY");
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
}

std::string VirtualDisplay::start() {
    int ends[2];
    if (pipe(ends) != 0) return "no pipe can be made";
    server_ = fork();
    if (server_ == 0) {
        close(ends[0]);
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        // The server picks a free number and writes it, followed by a newline, once it takes clients.
        const std::string descriptor = std::to_string(ends[1]);
        // Without -noreset it begins anew when its last client leaves, and refuses clients that connect
        // meanwhile.
        execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "640x480x24", "-noreset",
               "-nolisten", "tcp", nullptr);
        _exit(127);
    }
    close(ends[1]);
    std::string number;
    for (char digit = 0; read(ends[0], &digit, 1) == 1 && digit != '\n';) number += digit;
    close(ends[0]);
    if (!number.empty()) {
        setenv("DISPLAY", (":" + number).c_str(), 1);
        return {};
    }
    waitpid(server_, nullptr, 0);
    server_ = -1;
    return "$DISPLAY is not set, and Xvfb is not installed or does not start";
}

}  // namespace candela::test
