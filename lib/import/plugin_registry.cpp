#include <candela/plugin_registry.h>

#include "import/plugin_file.h"
#include "import/plugin_folders.h"
#include "import/text.h"

#include <candela/error.h>

#include <algorithm>
#include <map>

namespace candela {

namespace fs = std::filesystem;

const char* toString(PluginState state) {
    switch (state) {
        case PluginState::loaded:
            return "loaded";
        case PluginState::notALibrary:
            return "not a library";
        case PluginState::noEntryPoint:
            return "no entry point";
        case PluginState::wrongVersion:
            return "wrong version";
        case PluginState::refused:
            return "refused";
        case PluginState::badDescription:
            return "bad description";
        case PluginState::duplicate:
            return "duplicate";
    }
    return "unknown";
}

struct PluginRegistry::State {
    std::vector<PluginReport> reports;
    std::vector<std::shared_ptr<const LoadedPlugin>> plugins;
    // The first plugin with an ending or a scheme gets it.
    std::map<std::string, const candela_plugin*> byExtension, byScheme;

    void add(PluginFile file) {
        if (file.loaded) {
            if (const PluginReport* first = loadedReport(file.report.name)) {
                file.report.state = PluginState::duplicate;
                file.report.detail = joined("a plugin named '", first->name, "' was loaded before, from ",
                                            first->file.string());
            } else {
                take(file);
            }
        }
        reports.push_back(std::move(file.report));
    }

  private:
    const PluginReport* loadedReport(const std::string& name) const {
        const auto isIt = [&](const PluginReport& report) {
            return report.state == PluginState::loaded && report.name == name;
        };
        const auto found = std::find_if(reports.begin(), reports.end(), isIt);
        return found == reports.end() ? nullptr : &*found;
    }

    void take(const PluginFile& file) {
        const candela_plugin* plugin = &file.loaded->plugin;
        for (const std::string& extension : file.report.extensions) byExtension.emplace(extension, plugin);
        for (const std::string& scheme : file.report.schemes) byScheme.emplace(scheme, plugin);
        plugins.push_back(file.loaded);
    }
};

PluginRegistry::PluginRegistry(const std::vector<fs::path>& folders) {
    auto state = std::make_shared<State>();
    for (const fs::path& folder : searchOrder(processPluginFolders(folders)))
        for (const fs::path& file : pluginFilesIn(folder)) state->add(openPluginFile(file));
    state_ = std::move(state);
}

const PluginRegistry::State& PluginRegistry::state() const {
    if (state_) return *state_;
    throw Error(ErrorKind::badInput, "",
                "the plugin registry was moved from, but one with plugins was expected");
}

const std::vector<PluginReport>& PluginRegistry::reports() const {
    return state().reports;
}

const candela_plugin* PluginRegistry::importerForExtension(const std::string& extension) const {
    const auto& importers = state().byExtension;
    const auto found = importers.find(extension);
    return found == importers.end() ? nullptr : found->second;
}

const candela_plugin* PluginRegistry::importerForScheme(const std::string& scheme) const {
    const auto& importers = state().byScheme;
    const auto found = importers.find(scheme);
    return found == importers.end() ? nullptr : found->second;
}

std::vector<const candela_plugin*> PluginRegistry::imageDecoders() const {
    std::vector<const candela_plugin*> decoders;
    for (const auto& plugin : state().plugins)
        if (plugin->plugin.image_decoder) decoders.push_back(&plugin->plugin);
    return decoders;
}

std::optional<Subdivider> PluginRegistry::subdivider() const {
    for (const auto& plugin : state().plugins)
        if (plugin->plugin.subdivider) return Subdivider(std::make_shared<Subdivider::State>(plugin));
    return std::nullopt;
}

}  // namespace candela
