/// candela-render: draws a scene into an image file. See --help.

#include "commands.h"
#include "common/program.h"
#include "options.h"

#include <candela/threads.h>

#include <csignal>

int main(int argc, char** argv) {
    int signal = 0;
    const int code = runProgram("candela-render", [&] {
        const std::optional<Options> options = parseOptions(argc, argv);
        if (!options) return;
        candela::setThreadCount(options->threads);
        if (options->list) return printList(*options);
        signal = renderFrames(*options);
    });
    // Ends as the signal would have ended it, so that shells and schedulers see it: with code 128 + signal.
    if (signal != 0) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    return code;
}
