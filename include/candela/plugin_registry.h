#pragma once

#include <candela/export.h>
#include <candela/plugin.h>
#include <candela/subdivider.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// The result of loading one file that the registry found.
enum class PluginState {
    loaded,
    notALibrary,     ///< The dynamic loader refuses the file.
    noEntryPoint,    ///< It does not export `candela_plugin_query`.
    wrongVersion,    ///< Its major version is not ours.
    refused,         ///< Its query function returned NULL.
    badDescription,  ///< Its description breaks a rule of plugin.h.
    duplicate,       ///< A plugin of that name was loaded before, from an earlier folder.
};

/// The name of the state, such as "no entry point".
CANDELA_API const char* toString(PluginState state);

/// What the value of an option is.
enum class PluginOptionType { flag, integer, number, text, keyword };

/// An option that an importer takes in the query behind a file's name: "model.obj?level=3&flip".
struct PluginOption {
    std::string name = {}, help = {};
    PluginOptionType type = PluginOptionType::flag;
    double minimum = 0.0, maximum = 0.0;     ///< Of integers and numbers, both included; equal: no limits.
    std::vector<std::string> keywords = {};  ///< Of a keyword. The first one holds where no value is given.
};

/// The option with its value as it may be given, such as "level=1..8" or "subdivide[=catmullClark|loop]".
CANDELA_API std::string usageOf(const PluginOption& option);

struct PluginReport {
    std::filesystem::path file = {};
    PluginState state = PluginState::loaded;
    std::string detail = {};  ///< Why, in one line; empty when loaded.
    std::string name = {}, version = {},
                description = {};  ///< Of the plugin, where its description could be read.
    std::vector<std::string> extensions = {}, schemes = {};  ///< What its importer takes.
    bool subdivides = false;                                 ///< Whether it has a subdivider.
    bool decodesImages = false;                              ///< Whether it has an image decoder.
    std::vector<PluginOption> options = {};                  ///< Of its importer.
};

/// The plugins of this process. Searched in this order, the first plugin of a name wins: the folders given,
/// those of `CANDELA_PLUGIN_PATH` (colon-separated), `candela-plugins` beside the library's file, the install
/// folder. Never the working directory. Plugins stay loaded as long as the registry, or any copy of it,
/// lives, as a scene with a frame callback has one. A registry that was moved from throws `Error` (badInput)
/// when it is asked.
class CANDELA_API PluginRegistry {
  public:
    /// Searches and loads. A folder named in `folders` or in the environment that does not exist throws
    /// `Error` (environment).
    explicit PluginRegistry(const std::vector<std::filesystem::path>& folders = {});

    /// One report for each file found, in search order.
    const std::vector<PluginReport>& reports() const;

    /// The importer for a file name ending (lower case, no dot), or nullptr.
    const candela_plugin* importerForExtension(const std::string& extension) const;
    /// The importer for a URI scheme (lower case), or nullptr.
    const candela_plugin* importerForScheme(const std::string& scheme) const;
    /// The first plugin with a subdivider, in search order; none without one.
    std::optional<Subdivider> subdivider() const;

    /// The plugins that decode images, in search order.
    std::vector<const candela_plugin*> imageDecoders() const;

  private:
    struct State;
    const State& state() const;

    std::shared_ptr<const State> state_;
};

}  // namespace candela
