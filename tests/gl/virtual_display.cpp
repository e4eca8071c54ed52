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
    unavailableReason_ = start();
}

VirtualDisplay::~VirtualDisplay() {
    if (server_ < 0) return;
    unsetenv("DISPLAY");
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
}

std::string VirtualDisplay::start() {
    int pipeEnds[2];
    if (pipe(pipeEnds) != 0) return "cannot create a pipe";
    server_ = fork();
    if (server_ == 0) {
        close(pipeEnds[0]);
        const int null = open("/dev/null", O_WRONLY);
        dup2(null, STDOUT_FILENO);
        dup2(null, STDERR_FILENO);
        // The server chooses a free display number and writes it, with a newline, once it accepts clients.
        const std::string descriptor = std::to_string(pipeEnds[1]);
        // Without -noreset it restarts when its last client disconnects, and refuses clients
        // meanwhile.
        execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "640x480x24", "-noreset",
               "-nolisten", "tcp", nullptr);
        _exit(127);
    }
    close(pipeEnds[1]);
    std::string number;
    for (char digit = 0; read(pipeEnds[0], &digit, 1) == 1 && digit != '\n';) number += digit;
    close(pipeEnds[0]);
    if (!number.empty()) {
        setenv("DISPLAY", (":" + number).c_str(), 1);
        return {};
    }
    waitpid(server_, nullptr, 0);
    server_ = -1;
    return "$DISPLAY is not set, and Xvfb is not installed or does not start";
}

}  // namespace candela::test
