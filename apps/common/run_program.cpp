#include "run_program.h"

#include "usage_error.h"

#include <candela/error.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace {

enum ExitCode { done = 0, inputOrEnvironmentAtFault = 1, wrongUsage = 2 };

/// One line, whatever a library put into its message.
int report(const char* name, std::string text, ExitCode code) {
    std::ranges::replace(text, '\n', ' ');
    std::cerr << name << ": " << text << std::endl;
    return code;
}

}  // namespace

int runProgram(const char* name, const std::function<void()>& work) {
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
