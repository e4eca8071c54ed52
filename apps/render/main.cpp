/// candela-render: draws a scene into a picture file. See --help.

#include "common/program.h"
#include "list.h"
#include "options.h"
#include "render_command.h"

#include <candela/threads.h>

int main(int argc, char** argv) {
    return runProgram("candela-render", [&] {
        const std::optional<Options> options = parseOptions(argc, argv);
        if (!options) return;
        candela::setThreadCount(options->threads);
        if (options->list) return printList(*options);
        renderPictures(*options);
    });
}
