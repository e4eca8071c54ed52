#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

/// Gives a program what all have: --help that fits the terminal, --version, --man and --completion. Man page
/// and completion are made of the options that `app` has when it parses. `app` has its name and description.
void prepareCommandLine(CLI::App& app);

/// Reads the command line. Returns false when it asked for a text, which is printed then. Throws
/// `UsageError`, which names the option that an unknown one was probably meant to be.
bool parseCommandLine(CLI::App& app, int argc, const char* const* argv);

/// An option as the texts about it need it.
struct OptionText {
    std::vector<std::string> names;  ///< "-o", "--output"; empty of a positional argument.
    std::string
        placeholder;  ///< Such as "WxH" or "on|off"; the name of a positional argument; empty of a flag.
    std::string group;
    std::string description;  ///< Without line ends.
    bool isFlag = false;

    /// What may be given as its value: the lower-case words of the placeholder.
    std::vector<std::string> words() const;
    /// Whether its value is a file or a folder.
    bool takesFile() const;
    bool takesFolder() const;
};

/// The options of a program, positional ones first, in the order of --help; without hidden ones.
std::vector<OptionText> optionTexts(const CLI::App& app);

/// The page of a program in the language of man(7).
std::string manPage(const CLI::App& app);

/// The script that completes a program's command line in `shell`: bash, zsh or fish. Throws `UsageError`.
std::string completionScript(const CLI::App& app, const std::string& shell);

/// `text` in lines of at most `width` columns, broken at spaces; line ends of `text` count as spaces.
std::string wrapped(const std::string& text, std::size_t width);
