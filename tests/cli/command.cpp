#include "command.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace {

/// The prefix of the program's messages.
const std::string programName = std::filesystem::path(CANDELA_COMMAND).filename().string() + ": ";

[[noreturn]] void startCommand(const std::vector<std::string>& arguments, const CommandSetting& setting) {
    std::vector<std::string> argv{setting.program.empty() ? CANDELA_COMMAND : setting.program};
    argv.insert(argv.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& argument : argv) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    unsetenv("OCIO");
    unsetenv("CANDELA_PLUGIN_PATH");
    for (const std::string& variable : setting.environment) {
        const std::size_t equals = variable.find('=');
        setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
    }
    if (chdir(setting.folder.c_str()) != 0) _exit(126);
    setting.beforeStart();
    execv(pointers[0], pointers.data());
    _exit(127);
}

/// Appends available output of `descriptor`; false at its end. A terminal whose other side is closed gives
/// EIO.
bool readMore(int descriptor, std::string& text) {
    std::array<char, 4096> buffer{};
    const ssize_t count = read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) return true;
    if (count <= 0) return false;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    return true;
}

void readBoth(int outDescriptor, int errDescriptor, CommandResult& result) {
    std::array<pollfd, 2> waits{pollfd{outDescriptor, POLLIN, 0}, pollfd{errDescriptor, POLLIN, 0}};
    while (waits[0].fd >= 0 || waits[1].fd >= 0) {
        if (poll(waits.data(), waits.size(), -1) < 0 && errno != EINTR)
            throw std::system_error(errno, std::generic_category(), "poll");
        if (waits[0].fd >= 0 && waits[0].revents != 0 && !readMore(outDescriptor, result.out))
            waits[0].fd = -1;
        if (waits[1].fd >= 0 && waits[1].revents != 0 && !readMore(errDescriptor, result.err))
            waits[1].fd = -1;
    }
}

void waitFor(pid_t child, CommandResult& result) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
}

}  // namespace

CommandResult runCommand(const std::vector<std::string>& arguments, const CommandSetting& setting) {
    std::array<int, 2> out{}, err{};
    if (pipe2(out.data(), O_CLOEXEC) != 0 || pipe2(err.data(), O_CLOEXEC) != 0)
        throw std::system_error(errno, std::generic_category(), "pipe");
    const pid_t child = fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (child == 0) {
        dup2(out[1], STDOUT_FILENO);
        dup2(err[1], STDERR_FILENO);
        startCommand(arguments, setting);
    }
    close(out[1]);
    close(err[1]);
    setting.whileRunning(child);
    CommandResult result;
    readBoth(out[0], err[0], result);
    close(out[0]);
    close(err[0]);
    waitFor(child, result);
    return result;
}

CommandResult runOnTerminal(const std::vector<std::string>& arguments, const CommandSetting& setting) {
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child < 0) throw std::system_error(errno, std::generic_category(), "forkpty");
    if (child == 0) startCommand(arguments, setting);
    CommandResult result;
    while (readMore(terminal, result.out)) {
    }
    close(terminal);
    waitFor(child, result);
    return result;
}

namespace {

void expectOneLine(const std::string& text) {
    EXPECT_EQ(std::ranges::count(text, '\n'), 1) << text;
    EXPECT_TRUE(text.ends_with('\n')) << text;
}

}  // namespace

void expectFault(const CommandResult& result, const std::string& file, const std::string& reason) {
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(result.out, "");
    expectOneLine(result.err);
    EXPECT_TRUE(result.err.starts_with(programName + file + ": ")) << result.err;
    EXPECT_NE(result.err.find(reason), std::string::npos) << result.err << "lacks: " << reason;
}

void expectUsageError(const CommandResult& result, const std::string& reason) {
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_EQ(result.out, "");
    expectOneLine(result.err);
    EXPECT_TRUE(result.err.starts_with(programName)) << result.err;
    EXPECT_NE(result.err.find(reason), std::string::npos) << result.err << "lacks: " << reason;
}

void expectSuccess(const CommandResult& result) {
    EXPECT_EQ(result.exitCode, 0) << result.err;
}
