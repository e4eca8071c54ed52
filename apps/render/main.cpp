/// candela-render: draws a scene into an image file. See --help.

#include "commands.h"
#include "common/program.h"
#include "options.h"

#include <candela/threads.h>

int main(int argc, char** argv) {
    return runProgram("candela-render", [&] {
        const std::optional<Options> options = parseOptions(argc, argv);
        if (!options) return;
        candela::setThreadCount(options->threads);
        if (options->list) return printList(*options);
        renderFrames(*options);
    });
}
