#pragma once

#include <candela/plugin.h>
#include <candela/plugin_registry.h>

#include <string>
#include <vector>

namespace candela {

/// The options of an importer's description. Throws `BrokenRule`.
std::vector<PluginOption> checkedOptions(const candela_importer& importer);

/// The value of an option in a query.
struct OptionValue {
    std::uint32_t option = 0;  ///< Index of the options.
    double number = 0.0;       ///< As in `candela_option_value`.
    std::string text;
};

/// Reads a query, "level=3&flip". Throws `Error` (badInput) without a path for an option that is none of
/// `options`, for one that is given twice and for a value that it does not take.
std::vector<OptionValue> parseOptions(const std::vector<PluginOption>& options, const std::string& query);

}  // namespace candela
