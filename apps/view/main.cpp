/// candela-view: shows a scene in a window. See --help.

#include "application.h"
#include "common/program.h"
#include "view_options.h"

#include <candela/threads.h>

int main(int argc, char** argv) {
    return runProgram("candela-view", [&] {
        const std::optional<ViewOptions> options = parseViewOptions(argc, argv);
        if (!options) return;
        candela::setThreadCount(options->threads);
        Application(*options).run();
    });
}
