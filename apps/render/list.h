#pragma once

#include "options.h"

/// Prints what --list asks for, a line each, on standard output. Throws `candela::Error`.
void printList(const Options& options);
