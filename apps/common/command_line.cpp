#include "command_line.h"

#include "program.h"

#include <candela/nearest_name.h>
#include <candela/version.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <iostream>
#include <memory>
#include <sstream>

namespace {

/// Of a file or a pipe.
constexpr std::size_t plainWidth = 110;
constexpr std::size_t minWidth = 40;
constexpr std::size_t optionColumn = 32;

/// The number of columns of standard output.
std::size_t outputWidth() {
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return plainWidth;
    return std::clamp<std::size_t>(size.ws_col, minWidth, plainWidth);
}

/// `text` in lines that begin at column `indent`.
std::string indented(const std::string& text, std::size_t indent, std::size_t width) {
    std::string lines = std::string(indent, ' ');
    for (const char c : wrapped(text, width - indent))
        lines += c == '\n' ? "\n" + std::string(indent, ' ') : std::string(1, c);
    return lines;
}

constexpr std::size_t exampleIndent = 6;

/// An indented line: a command and after several spaces what it does, which goes onto the next line where
/// both are too long; or a text, behind a number or not.
std::string fittedLine(const std::string& line, std::size_t width) {
    if (line.size() <= width) return line;
    const std::size_t start = line.find_first_not_of(' ');
    if (line.compare(start, 8, "candela-") == 0) {
        const std::size_t gap = line.find("   ", start);
        if (gap == line.npos) return line;
        return line.substr(0, gap) + "\n" + indented(line.substr(gap), exampleIndent, width);
    }
    const std::size_t gap = line.find("  ", start);
    const std::size_t column = gap == line.npos ? start : line.find_first_not_of(' ', gap);
    if (column > width / 2) return indented(line, exampleIndent, width);
    return line.substr(0, column) + indented(line.substr(column), column, width).substr(column);
}

std::string fittedLines(const std::string& text, std::size_t width) {
    std::istringstream lines(text);
    std::string fitted;
    for (std::string line; std::getline(lines, line);) {
        const bool isProse = !line.starts_with(' ');
        fitted += (isProse ? wrapped(line, width) : fittedLine(line, width)) + "\n";
    }
    return fitted;
}

/// Descriptions fill the columns that the terminal has beside the options.
class FittingFormatter : public CLI::Formatter {
  public:
    FittingFormatter() : width_(outputWidth()) {
        column_width(std::min(optionColumn, width_ / 3));
        label("OPTIONS", "OPTION...");
    }

    std::string make_option_desc(const CLI::Option* option) const override {
        return wrapped(option->get_description(), width_ - get_column_width());
    }
    std::string make_description(const CLI::App* app) const override {
        return wrapped(app->get_description(), width_) + "\n\n";
    }
    std::string make_footer(const CLI::App* app) const override {
        return "\n" + fittedLines(app->get_footer(), width_);
    }

  private:
    std::size_t width_;
};

std::vector<std::string> optionNames(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

/// What CLI11 says of arguments that nothing takes, and what the first one may have been meant to be.
std::string unexpectedText(const CLI::App& app, const std::string& message) {
    for (const std::string& argument : app.remaining())
        if (argument.starts_with("--"))
            return message + candela::didYouMean(argument.substr(0, argument.find('=')), optionNames(app));
    return message;
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t width) {
    std::istringstream words(text);
    std::string lines;
    std::size_t column = 0;
    for (std::string word; words >> word;) {
        const bool fits = column == 0 || column + 1 + word.size() <= width;
        if (!fits) lines += "\n";
        if (fits && column > 0) lines += " ";
        column = (fits && column > 0 ? column + 1 : 0) + word.size();
        lines += word;
    }
    return lines;
}

std::vector<std::string> OptionText::words() const {
    std::vector<std::string> words;
    std::istringstream parts(placeholder.substr(0, placeholder.find('[')));
    for (std::string part; std::getline(parts, part, '|');) {
        const bool isWord = !part.empty() && std::ranges::all_of(part, [](unsigned char c) {
            return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_';
        });
        if (isWord) words.push_back(part);
    }
    return words;
}

bool OptionText::takesFile() const {
    return placeholder.starts_with("FILE") || placeholder == "CONFIG" || placeholder == "SCENE" ||
           placeholder.ends_with("|FILE");
}

bool OptionText::takesFolder() const {
    return placeholder == "DIR";
}

std::vector<OptionText> optionTexts(const CLI::App& app) {
    std::vector<OptionText> texts;
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_group().empty()) continue;
        OptionText text;
        for (const std::string& name : option->get_snames()) text.names.push_back("-" + name);
        for (const std::string& name : option->get_lnames()) text.names.push_back("--" + name);
        text.isFlag = option->get_items_expected_max() == 0;
        text.placeholder = text.isFlag ? "" : option->get_type_name();
        if (text.names.empty()) text.placeholder = option->get_name();
        text.group = option->get_group();
        text.description = wrapped(option->get_description(), std::string::npos);
        texts.push_back(text);
    }
    std::ranges::stable_partition(texts, [](const OptionText& text) { return text.names.empty(); });
    return texts;
}

void prepareCommandLine(CLI::App& app) {
    app.formatter(std::make_shared<FittingFormatter>());
    app.set_help_flag("-h,--help", "Show this help")->group("Asking");
    app.set_version_flag("--version", "candela " CANDELA_VERSION, "Show the version")->group("Asking");
    // The build makes files of them.
    app.add_flag_callback(
           "--man", [] {}, "Show the man page")
        ->group("");
    app.add_option("--completion", "Show the completion script of bash, zsh or fish")->group("");
}

bool parseCommandLine(CLI::App& app, int argc, const char* const* argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        app.exit(asked, std::cout, std::cerr);
        return false;
    } catch (const CLI::ExtrasError& error) {
        throw UsageError(unexpectedText(app, error.what()));
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    if (app.count("--man") > 0) std::cout << manPage(app);
    if (app.count("--completion") > 0)
        std::cout << completionScript(app, app["--completion"]->as<std::string>());
    return app.count("--man") == 0 && app.count("--completion") == 0;
}
