#include "command_line.h"

#include <candela/version.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace {

/// Text that man(7) shows as it is.
std::string escaped(const std::string& text) {
    std::string shown;
    for (const char c : text) {
        const bool startsLine = shown.empty() || shown.back() == '\n';
        if (startsLine && (c == '.' || c == '\'')) shown += "\\&";
        if (c == '\\')
            shown += "\\e";
        else if (c == '-')
            shown += "\\-";
        else
            shown += c;
    }
    return shown;
}

std::string headOf(const OptionText& option) {
    std::string head;
    for (const std::string& name : option.names)
        head += (head.empty() ? "" : ", ") + ("\\fB" + escaped(name)) + "\\fR";
    if (!option.placeholder.empty())
        head += (head.empty() ? "" : " ") + ("\\fI" + escaped(option.placeholder)) + "\\fR";
    return ".TP\n" + head + "\n" + escaped(option.description) + "\n";
}

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) {
        return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    });
    return text;
}

/// The footer: lines without an indent are titles or paragraphs, indented ones stay as they are.
std::string footerOf(const std::string& footer) {
    std::istringstream lines(footer);
    std::string text;
    bool isExample = false;
    for (std::string line; std::getline(lines, line);) {
        const bool indented = line.starts_with(' ');
        if (indented != isExample) text += indented ? ".nf\n" : ".fi\n";
        isExample = indented;
        if (line.ends_with(':'))
            text += ".SH " + escaped(upper(line.substr(0, line.size() - 1))) + "\n";
        else if (!line.empty())
            text += indented ? escaped(line) + "\n" : ".PP\n" + escaped(line) + "\n";
    }
    return text + (isExample ? ".fi\n" : "");
}

}  // namespace

std::string manPage(const CLI::App& app) {
    const std::string name = app.get_name(), description = wrapped(app.get_description(), std::string::npos);
    const std::vector<OptionText> options = optionTexts(app);
    // "Draws a scene" is said of the program: a man page's summary has neither the capital nor the dot.
    std::string summary = description.substr(0, description.find('.'));
    if (!summary.empty())
        summary[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(summary[0])));
    std::string page = ".TH " + upper(name) + " 1 \"\" \"candela " CANDELA_VERSION "\" \"User Commands\"\n";
    page += ".SH NAME\n" + escaped(name) + " \\- " + escaped(summary) + "\n";
    page += ".SH SYNOPSIS\n.B " + escaped(name) + "\n[\\fIOPTION\\fR...]";
    for (const OptionText& option : options)
        if (option.names.empty()) page += " [\\fI" + escaped(option.placeholder) + "\\fR]";
    page += "\n.SH DESCRIPTION\n" + escaped(description) + "\n.SH OPTIONS\n";
    std::vector<std::string> groups;
    for (const OptionText& option : options)
        if (std::ranges::find(groups, option.group) == groups.end()) groups.push_back(option.group);
    for (const std::string& group : groups) {
        page += ".SS " + escaped(group) + "\n";
        for (const OptionText& option : options)
            if (option.group == group) page += headOf(option);
    }
    return page + footerOf(app.get_footer());
}
