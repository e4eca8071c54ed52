#include "command_line.h"

#include "parse.h"
#include "program.h"

#include <algorithm>
#include <array>

namespace {

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
    return text;
}

/// The first clause of a description, which fits beside an option.
std::string summaryOf(const OptionText& option) {
    const std::size_t end = option.description.find_first_of(".:;");
    return option.description.substr(0, end);
}

/// The name of a shell function for a program.
std::string functionOf(const CLI::App& app) {
    std::string name = "_" + app.get_name();
    std::ranges::replace(name, '-', '_');
    return name;
}

std::string bashScript(const CLI::App& app) {
    const std::string function = functionOf(app);
    std::string all, cases;
    for (const OptionText& option : optionTexts(app)) {
        if (option.names.empty()) continue;
        all += (all.empty() ? "" : " ") + joined(option.names, " ");
        if (option.isFlag) continue;
        std::string values = joined(option.words(), " ");
        std::string reply = "COMPREPLY=($(compgen";
        if (option.takesFile()) reply += " -f";
        if (option.takesFolder()) reply += " -d";
        if (!values.empty()) reply += " -W '" + values + "'";
        reply += " -- \"$current\"))";
        const bool known = option.takesFile() || option.takesFolder() || !values.empty();
        cases +=
            "    " + joined(option.names, " | ") + ") " + (known ? reply : "COMPREPLY=()") + "; return ;;\n";
    }
    return "# bash completion of " + app.get_name() + "\n" + function +
           "() {\n"
           "    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}\n"
           "    case $previous in\n" +
           cases +
           "    esac\n"
           "    if [[ $current == -* ]]; then\n"
           "        COMPREPLY=($(compgen -W '" +
           all +
           "' -- \"$current\"))\n"
           "    else\n"
           "        COMPREPLY=($(compgen -f -- \"$current\"))\n"
           "    fi\n"
           "}\n"
           "complete -o filenames -F " +
           function + " " + app.get_name() + "\n";
}

/// Text within a single-quoted argument of _arguments, where brackets and colons have a meaning.
std::string zshText(const std::string& text) {
    std::string quoted;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') quoted += '\\';
        quoted += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return quoted;
}

std::string zshAction(const OptionText& option) {
    const std::string words = joined(option.words(), " ");
    if (option.takesFile()) return "_files";
    if (option.takesFolder()) return "_files -/";
    return words.empty() ? " " : "(" + words + ")";
}

std::string zshScript(const CLI::App& app) {
    std::string script = "#compdef " + app.get_name() + "\n_arguments -s -S";
    for (const OptionText& option : optionTexts(app)) {
        const std::string value =
            option.isFlag ? "" : ":" + zshText(option.placeholder) + ":" + zshAction(option);
        if (option.names.empty()) {
            script += " \\\n    '" + value + "'";
            continue;
        }
        for (const std::string& name : option.names)
            script += " \\\n    '" + name + "[" + zshText(summaryOf(option)) + "]" + value + "'";
    }
    return script + "\n";
}

std::string fishText(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return quoted + "'";
}

std::string fishScript(const CLI::App& app) {
    std::string script;
    for (const OptionText& option : optionTexts(app)) {
        if (option.names.empty()) continue;
        script += "complete -c " + app.get_name();
        for (const std::string& name : option.names)
            script += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
        if (!option.isFlag) script += option.takesFile() || option.takesFolder() ? " -r -F" : " -x";
        const std::string words = joined(option.words(), " ");
        if (!words.empty()) script += " -a " + fishText(words);
        script += " -d " + fishText(summaryOf(option)) + "\n";
    }
    return script;
}

}  // namespace

std::string completionScript(const CLI::App& app, const std::string& shell) {
    const std::string known = parseWord("--completion", shell, std::array{"bash", "zsh", "fish"},
                                        [](const char* name) { return name; });
    if (known == "bash") return bashScript(app);
    return known == "zsh" ? zshScript(app) : fishScript(app);
}
