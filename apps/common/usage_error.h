#pragma once

#include <stdexcept>

/// The command line is wrong: exit code 2. The text names the option, what was given, and what is expected.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
