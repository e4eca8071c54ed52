#include "import/scene_source.h"

#include "import/text.h"

#include <candela/error.h>
#include <candela/nearest_name.h>

#include <optional>
#include <set>
#include <vector>

namespace candela {
namespace fs = std::filesystem;
namespace {

bool isSchemeCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
}

struct SchemeAndRest {
    std::string scheme, rest;
};

// RFC 3986, 3.1, with two or more characters.
std::optional<SchemeAndRest> splitScheme(const std::string& uri) {
    const std::size_t colon = uri.find(':');
    if (colon == std::string::npos || colon < 2) return std::nullopt;
    const std::string scheme = lowerCase(uri.substr(0, colon));
    if (scheme[0] < 'a' || scheme[0] > 'z') return std::nullopt;
    for (const char c : scheme)
        if (!isSchemeCharacter(c)) return std::nullopt;
    return SchemeAndRest{scheme, uri.substr(colon + 1)};
}

// ".glb", ".gltf", "plaza:"
std::set<std::string> supportedSources(const PluginRegistry& plugins) {
    std::set<std::string> supported;
    for (const PluginReport& report : plugins.reports()) {
        if (report.state != PluginState::loaded) continue;
        for (const std::string& extension : report.extensions) supported.insert("." + extension);
        for (const std::string& scheme : report.schemes) supported.insert(scheme + ":");
    }
    return supported;
}

// "the plugins loaded take .glb, .gltf and plaza:"
std::string listOf(const std::set<std::string>& supported) {
    if (supported.empty()) return "no plugin is loaded";
    std::string list;
    std::size_t left = supported.size();
    for (const std::string& entry : supported) {
        if (!list.empty()) list += left == 1 ? " and " : ", ";
        list += entry;
        --left;
    }
    return "the plugins loaded take " + list;
}

// The same, and which of them `source`, an ending or a scheme, was probably meant to be.
std::string supportedText(const PluginRegistry& plugins, const std::string& source) {
    const std::set<std::string> supported = supportedSources(plugins);
    const std::vector<std::string> names(supported.begin(), supported.end());
    return listOf(supported) + didYouMean(source, names);
}

SceneSource schemeSource(const PluginRegistry& plugins, const std::string& uri, const SchemeAndRest& parts) {
    const candela_plugin* plugin = plugins.importerForScheme(parts.scheme);
    if (!plugin)
        throw Error(ErrorKind::unsupported, uri,
                    joined("there is no such file, and no plugin takes the scheme '", parts.scheme, ":'; ",
                           supportedText(plugins, parts.scheme + ":")));
    return {plugin, {}, parts.rest, std::nullopt};
}

const candela_plugin* importerFor(const PluginRegistry& plugins, const std::string& uri) {
    const std::string ending = fs::path(uri).extension().string();
    if (ending.size() < 2)
        throw Error(
            ErrorKind::unsupported, uri,
            "the file's name has no ending that tells its format; " + listOf(supportedSources(plugins)));
    const candela_plugin* plugin = plugins.importerForExtension(lowerCase(ending.substr(1)));
    if (!plugin)
        throw Error(ErrorKind::unsupported, uri,
                    joined("no plugin takes files ending in '", oneLine(ending), "'; ",
                           supportedText(plugins, ending)));
    return plugin;
}

void requireQueries(const candela_plugin& plugin, const std::string& uri, const std::string& query) {
    constexpr std::uint32_t firstWithQueries = 1;
    if (plugin.minor >= firstWithQueries) return;
    throw Error(ErrorKind::unsupported, uri,
                joined("the plugin '", plugin.name, "' takes no query, but '?", oneLine(query),
                       "' follows the name"));
}

SceneSource fileSource(const PluginRegistry& plugins, const std::string& uri, const std::string& path) {
    const candela_plugin* plugin = importerFor(plugins, path);
    std::error_code error;
    const fs::path file = fs::canonical(path, error);
    if (error) throw Error(ErrorKind::environment, uri, error.message());
    return {plugin, file.parent_path(), file.filename().string(), std::nullopt};
}

// The file before the last '?' with the query behind it, where there is such a file.
std::optional<SceneSource> fileWithQuery(const PluginRegistry& plugins, const std::string& uri) {
    const std::size_t mark = uri.rfind('?');
    if (mark == std::string::npos) return std::nullopt;
    const std::string path = uri.substr(0, mark);
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return std::nullopt;
    SceneSource source = fileSource(plugins, uri, path);
    source.query = uri.substr(mark + 1);
    requireQueries(*source.plugin, uri, *source.query);
    return source;
}

}  // namespace

SceneSource findSource(const PluginRegistry& plugins, const std::string& uri) {
    if (uri.empty()) throw Error(ErrorKind::badInput, "", "the name of the scene is empty");
    if (uri.find('\0') != std::string::npos)
        throw Error(ErrorKind::badInput, oneLine(uri), "the name of the scene holds a zero byte");
    std::error_code error;
    const fs::file_status status = fs::status(uri, error);
    const bool absent = status.type() == fs::file_type::not_found;
    if (!fs::exists(status)) {
        if (const auto source = fileWithQuery(plugins, uri)) return *source;
        if (const auto parts = splitScheme(uri)) return schemeSource(plugins, uri, *parts);
    }
    if (absent) throw Error(ErrorKind::environment, uri, "there is no such file");
    if (status.type() == fs::file_type::none) throw Error(ErrorKind::environment, uri, error.message());
    if (fs::is_directory(status))
        throw Error(ErrorKind::badInput, uri, "this is a folder, but a scene file was expected");
    if (!fs::is_regular_file(status)) throw Error(ErrorKind::badInput, uri, "this is not a regular file");
    return fileSource(plugins, uri, uri);
}

}  // namespace candela
