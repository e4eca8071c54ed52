#pragma once

#include <functional>

/// Runs a program's work and gives its exit code: 0 done; 1 the input or the environment is at fault, with
/// one line on standard error; 2 wrong usage (`UsageError`), likewise. `name` is the program's.
int runProgram(const char* name, const std::function<void()>& work);
