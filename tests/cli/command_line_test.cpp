// What is made of the table of options: help that fits the terminal, man page, completion, and the names that
// a wrong one was probably meant to be.

#include "command.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <sstream>

namespace {

using Names = std::vector<std::string>;

std::string textOf(const Names& arguments) {
    const CommandResult result = runCommand(arguments);
    expectSuccess(result);
    EXPECT_EQ(result.err, "");
    return result.out;
}

/// The long options that --help shows.
std::set<std::string> helpedOptions() {
    std::set<std::string> options;
    std::istringstream lines(textOf({"--help"}));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t start = line.find("--");
        if (line.starts_with("  -") && start != line.npos)
            options.insert(line.substr(start, line.find_first_of(" ,", start) - start));
    }
    return options;
}

struct Mistake {
    Names arguments;
    std::string meant;
};

TEST(CommandLine, NamesWhatWasMeant) {
    const std::array mistakes{
        Mistake{{"square.gltf", "--sampels", "4"}, "--samples"},
        Mistake{{"square.gltf", "--enviroment=sky"}, "--environment"},
        Mistake{{"square.gltf", "--technique", "volume"}, "volumes"},
        Mistake{{"square.gltf", "--show", "nromals"}, "normals"},
        Mistake{{"square.gltf", "-o", "a.exr", "--aov", "Z,base_colour"}, "base_color"},
        Mistake{{"square.gltf", "--camera", "fron"}, "front"},
        Mistake{{"square.gltf", "--camera", "front,farr"}, "far"},
        Mistake{{"square.gltf", "--view", "ACES 1.0 SDRR"}, "ACES 1.0 SDR"},
        Mistake{{"square.gltf", "--list", "camera"}, "cameras"},
        Mistake{{"plazza:16"}, "plaza:"},
        Mistake{{"square.gtlf"}, ".gltf"},
    };
    const TemporaryFolder folder;
    folder.write("square.gltf", sampleScene());
    folder.write("square.gtlf", sampleScene());
    for (const Mistake& mistake : mistakes) {
        SCOPED_TRACE(testing::PrintToString(mistake.arguments));
        const CommandResult result = runCommand(mistake.arguments, {.folder = folder.path()});
        EXPECT_NE(result.exitCode, 0);
        EXPECT_NE(result.err.find("(did you mean " + mistake.meant + "?)"), std::string::npos) << result.err;
    }
}

TEST(CommandLine, SuggestsNothingFar) {
    for (const Names& arguments : {Names{"a.gltf", "--no-such-option"}, {"a.gltf", "--technique", "magic"}}) {
        const CommandResult result = runCommand(arguments);
        EXPECT_EQ(result.exitCode, 2);
        EXPECT_EQ(result.err.find("did you mean"), std::string::npos) << result.err;
    }
}

TEST(CommandLine, HelpFitsTheTerminal) {
    for (const std::size_t width : {50u, 80u}) {
        const CommandResult result = runOnTerminal(
            {"-c", "stty columns " + std::to_string(width) + "; exec \"$0\" --help", CANDELA_COMMAND},
            {.program = "/bin/sh"});
        EXPECT_EQ(result.exitCode, 0) << result.out;
        std::istringstream lines(result.out);
        for (std::string line; std::getline(lines, line);) {
            if (line.ends_with('\r')) line.pop_back();
            // Of what can not be broken: an option with its placeholder, and the command of an example.
            const bool isWhole = line.starts_with("  -") || line.starts_with("  candela-render ");
            EXPECT_TRUE(isWhole || line.size() <= width) << line;
        }
        EXPECT_NE(result.out.find("--samples"), std::string::npos);
    }
}

TEST(CommandLine, ManPageHasEveryOption) {
    const std::string page = textOf({"--man"});
    EXPECT_TRUE(page.starts_with(".TH CANDELA-RENDER 1 ")) << page.substr(0, 100);
    for (const char* section :
         {".SH NAME\n", ".SH SYNOPSIS\n", ".SH OPTIONS\n", ".SH EXAMPLES\n", ".SH EXIT CODES\n"})
        EXPECT_NE(page.find(section), std::string::npos) << section;
    for (std::string option : helpedOptions()) {
        for (std::size_t dash = 0; (dash = option.find('-', dash)) != option.npos; dash += 2)
            option.insert(dash, "\\");
        EXPECT_NE(page.find("\\fB" + option + "\\fR"), std::string::npos) << option;
    }
}

TEST(CommandLine, CompletionsHaveEveryOptionAndItsWords) {
    const std::string bash = textOf({"--completion", "bash"}), zsh = textOf({"--completion", "zsh"}),
                      fish = textOf({"--completion", "fish"});
    for (const std::string& option : helpedOptions()) {
        EXPECT_NE(bash.find(option), std::string::npos) << option;
        EXPECT_NE(zsh.find("'" + option + "["), std::string::npos) << option;
        EXPECT_NE(fish.find(" -l " + option.substr(2) + " "), std::string::npos) << option;
    }
    EXPECT_NE(zsh.find("(auto tiles volumes fullscreen)"), std::string::npos);
    EXPECT_NE(fish.find(" -l brdf -x -a 'course gltf' "), std::string::npos);
    expectUsageError(runCommand({"--completion", "csh"}), "bash, zsh, fish");
}

/// The completions that bash offers for the last of the words of a command line.
std::string completedByBash(const std::string& words) {
    const TemporaryFolder folder;
    folder.write("completion", textOf({"--completion", "bash"}));
    folder.write("room.gltf", "");
    const CommandResult result = runCommand(
        {"-c", "source ./completion; COMP_WORDS=(" + words +
                   "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _candela_render; echo \"${COMPREPLY[@]}\""},
        {.folder = folder.path(), .program = "/bin/bash"});
    EXPECT_EQ(result.err, "");
    return result.out;
}

TEST(CommandLine, BashCompletes) {
    EXPECT_EQ(completedByBash("candela-render --tech"), "--technique\n");
    EXPECT_EQ(completedByBash("candela-render --technique f"), "fullscreen\n");
    EXPECT_EQ(completedByBash("candela-render ro"), "room.gltf\n");
    EXPECT_EQ(completedByBash("candela-render --samples ''"), "\n") << "a number";
}

}  // namespace
