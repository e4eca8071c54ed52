#pragma once

#include "options.h"

namespace CLI {
class App;
}

/// Declares the options of how pictures are encoded, and fills `options` while the command line is parsed.
void declareEncoding(CLI::App& app, Options& options);

/// The same of sequences, and of the parts of them that a process draws.
void declareSequence(CLI::App& app, Options& options);

/// Checks these options together, after parsing, and takes the format of the picture. Throws `UsageError`.
void finishOutput(const CLI::App& app, Options& options);
