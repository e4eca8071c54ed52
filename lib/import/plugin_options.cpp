#include "import/plugin_options.h"

#include "import/plugin_abi.h"
#include "import/plugin_rules.h"
#include "import/text.h"

#include <candela/error.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <set>

namespace candela {

namespace {

constexpr std::uint32_t maxOptions = 64;
constexpr std::size_t maxKeywords = 64;
/// Doubles hold every integer up to here.
constexpr double maxInteger = 9007199254740992.0;

std::vector<std::string> checkedKeywords(const char* const* keywords, const std::string& what) {
    std::vector<std::string> checked;
    if (!keywords) throw BrokenRule{what + " is a keyword, but its keywords are NULL"};
    for (std::size_t i = 0; keywords[i]; ++i) {
        if (i == maxKeywords)
            throw BrokenRule{
                joined(what, " lists more than ", maxKeywords, " keywords, or the list has no end")};
        checked.push_back(checkedLine(keywords[i], what + ": a keyword"));
    }
    if (checked.empty()) throw BrokenRule{what + " is a keyword of nothing"};
    return checked;
}

PluginOption checkedOption(const candela_option& source, std::uint32_t index) {
    constexpr std::array types{PluginOptionType::flag, PluginOptionType::integer, PluginOptionType::number,
                               PluginOptionType::text, PluginOptionType::keyword};
    PluginOption option;
    option.name = checkedName(source.name, joined("the name of its option ", index));
    const std::string what = "its option '" + option.name + "'";
    option.help = checkedLine(source.help, what + ": the help");
    const std::uint32_t type = numberOf(source.type);
    if (type >= types.size()) throw BrokenRule{joined(what, ": there is no type ", type)};
    option.type = types[type];
    if (option.type == PluginOptionType::keyword) option.keywords = checkedKeywords(source.keywords, what);
    if (option.type != PluginOptionType::integer && option.type != PluginOptionType::number) return option;
    if (!std::isfinite(source.minimum) || !std::isfinite(source.maximum) || source.minimum > source.maximum)
        throw BrokenRule{what + ": its minimum and its maximum are no range"};
    option.minimum = source.minimum;
    option.maximum = source.maximum;
    return option;
}

bool hasLimits(const PluginOption& option) {
    return option.minimum != 0.0 || option.maximum != 0.0;
}

bool isNumeric(const PluginOption& option) {
    return option.type == PluginOptionType::integer || option.type == PluginOptionType::number;
}

/// What a value has to be, for messages.
std::string expected(const PluginOption& option) {
    const char* kind = option.type == PluginOptionType::integer ? "an integer" : "a number";
    switch (option.type) {
        case PluginOptionType::flag:
            return "0 or 1";
        case PluginOptionType::text:
            return "a text";
        case PluginOptionType::keyword: {
            std::string list;
            for (std::size_t i = 0; i < option.keywords.size(); ++i) {
                const bool isLast = i + 1 == option.keywords.size();
                list += (i == 0 ? "" : isLast ? " or " : ", ") + option.keywords[i];
            }
            return list;
        }
        default:
            return hasLimits(option) ? joined(kind, " from ", option.minimum, " to ", option.maximum) : kind;
    }
}

std::optional<double> numberIn(const std::string& text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<double> valueOf(const PluginOption& option, const std::string& text) {
    if (option.type == PluginOptionType::text) return 0.0;
    if (option.type == PluginOptionType::keyword) {
        const auto found = std::ranges::find(option.keywords, text);
        if (found == option.keywords.end()) return std::nullopt;
        return static_cast<double>(found - option.keywords.begin());
    }
    const std::optional<double> number = numberIn(text);
    if (!number) return std::nullopt;
    if (option.type == PluginOptionType::flag)
        return *number == 0.0 || *number == 1.0 ? number : std::nullopt;
    const bool within = !hasLimits(option) || (*number >= option.minimum && *number <= option.maximum);
    const bool isWhole = *number == std::trunc(*number) && std::abs(*number) <= maxInteger;
    return within && (isWhole || option.type == PluginOptionType::number) ? number : std::nullopt;
}

[[noreturn]] void refuse(const std::string& text) {
    throw Error(ErrorKind::badInput, "", "query: " + text);
}

std::string usageOfAll(const std::vector<PluginOption>& options) {
    std::string text;
    for (const PluginOption& option : options) text += (text.empty() ? "" : ", ") + usageOf(option);
    return text;
}

OptionValue parseItem(const std::vector<PluginOption>& options, const std::string& item) {
    const std::size_t equals = item.find('=');
    const std::string name = item.substr(0, equals);
    const auto found = std::ranges::find(options, name, &PluginOption::name);
    if (found == options.end())
        refuse(joined("'", oneLine(item), "' is none of the options ", usageOfAll(options)));
    OptionValue value{static_cast<std::uint32_t>(found - options.begin()), 0.0, ""};
    if (equals != std::string::npos) {
        value.text = item.substr(equals + 1);
    } else if (found->type == PluginOptionType::flag) {
        value.text = "1";
    } else if (found->type == PluginOptionType::keyword) {
        value.text = found->keywords.front();
    } else {
        refuse(joined("'", name, "' has no value, but ", expected(*found), " was expected"));
    }
    const std::optional<double> number = valueOf(*found, value.text);
    if (!number) refuse(joined(oneLine(item), ", but ", expected(*found), " was expected"));
    value.number = *number;
    return value;
}

}  // namespace

std::string usageOf(const PluginOption& option) {
    if (option.type == PluginOptionType::flag) return option.name;
    if (option.type == PluginOptionType::keyword) {
        std::string keywords;
        for (const std::string& keyword : option.keywords)
            keywords += (keywords.empty() ? "" : "|") + keyword;
        return option.name + "[=" + keywords + "]";
    }
    if (isNumeric(option) && hasLimits(option))
        return joined(option.name, "=", option.minimum, "..", option.maximum);
    return option.name + (option.type == PluginOptionType::text      ? "=TEXT"
                          : option.type == PluginOptionType::integer ? "=INTEGER"
                                                                     : "=NUMBER");
}

std::vector<PluginOption> checkedOptions(const candela_importer& importer) {
    std::vector<PluginOption> options;
    if (importer.option_count == 0) return options;
    if (!importer.options)
        throw BrokenRule{joined("its option_count is ", importer.option_count, ", but its options are NULL")};
    if (importer.option_count > maxOptions)
        throw BrokenRule{joined("it has more than ", maxOptions, " options")};
    for (std::uint32_t i = 0; i < importer.option_count; ++i) {
        candela_option source{};
        std::memcpy(static_cast<void*>(&source), importer.options + i, sizeof source);
        options.push_back(checkedOption(source, i));
        const auto same = std::ranges::count(options, options.back().name, &PluginOption::name);
        if (same > 1) throw BrokenRule{"it has two options '" + options.back().name + "'"};
    }
    return options;
}

std::vector<OptionValue> parseOptions(const std::vector<PluginOption>& options, const std::string& query) {
    std::vector<OptionValue> values;
    std::set<std::uint32_t> given;
    for (std::size_t first = 0; first <= query.size();) {
        const std::size_t end = std::min(query.find('&', first), query.size());
        values.push_back(parseItem(options, query.substr(first, end - first)));
        if (!given.insert(values.back().option).second)
            refuse("'" + options[values.back().option].name + "' is given twice");
        first = end + 1;
    }
    return values;
}

}  // namespace candela
