/// candela-render: draws a scene into a picture file. See --help.

#include "common/usage_error.h"
#include "list.h"
#include "options.h"
#include "render_command.h"

#include <candela/error.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace {

enum ExitCode { done = 0, inputOrEnvironmentAtFault = 1, wrongUsage = 2 };

/// One line, whatever a library put into its message.
int report(std::string text, ExitCode code) {
    std::ranges::replace(text, '\n', ' ');
    std::cerr << "candela-render: " << text << std::endl;
    return code;
}

int run(int argc, const char* const* argv) {
    const std::optional<Options> options = parseOptions(argc, argv);
    if (options && options->list) printList(*options);
    if (options && !options->list) renderPictures(*options);
    if (!std::cout.flush())
        throw candela::Error(candela::ErrorKind::environment, "standard output", "cannot be written");
    return done;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const UsageError& error) {
        return report(std::string(error.what()) + "; --help shows the options", wrongUsage);
    } catch (const std::bad_alloc&) {
        return report("there is not enough memory", inputOrEnvironmentAtFault);
    } catch (const std::exception& error) {
        return report(error.what(), inputOrEnvironmentAtFault);
    }
}
