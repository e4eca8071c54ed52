#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// Exit status and output of a child process.
struct CommandResult {
    int exitCode = -1;  ///< -1 when a signal ended it.
    int signal = 0;     ///< 0 when it ended by itself.
    std::string out, err;
};

struct CommandSetting {
    std::filesystem::path folder = ".";         ///< Working directory.
    std::vector<std::string> environment{};     ///< NAME=VALUE, added to this process's.
    std::function<void()> beforeStart = [] {};  ///< Runs in the child.
    std::function<void(int)> whileRunning = [](int) {
    };                      ///< Runs in this process, with the child's process id.
    std::string program{};  ///< Replaces the program under test.
};

/// Runs the program under test (CANDELA_COMMAND of the build) with `arguments`, its output going into pipes.
/// It inherits the environment without $OCIO and $CANDELA_PLUGIN_PATH.
CommandResult runCommand(const std::vector<std::string>& arguments, const CommandSetting& setting = {});

/// Runs it on a terminal of its own; `out` is what appeared there, standard output and error together.
CommandResult runOnTerminal(const std::vector<std::string>& arguments, const CommandSetting& setting = {});

/// Expects exit code 1 and exactly one line on standard error, "PROGRAM: FILE: ...", that contains
/// `reason`; nothing on standard output.
void expectFault(const CommandResult& result, const std::string& file, const std::string& reason);

/// Expects exit code 2 and exactly one line on standard error that contains `reason`.
void expectUsageError(const CommandResult& result, const std::string& reason);

/// Expects exit code 0.
void expectSuccess(const CommandResult& result);
