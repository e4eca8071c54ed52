#include "import/plugin_file.h"

#include "import/plugin_description.h"
#include "import/text.h"

#include <dlfcn.h>

#include <string>

namespace candela {
namespace {

// The loader's messages begin with the file, which the report names by itself.
std::string loaderMessage(const std::filesystem::path& file) {
    const char* text = ::dlerror();
    if (!text) return "the dynamic loader gives no reason";
    const std::string message = text, prefix = file.string() + ": ";
    return oneLine(message.starts_with(prefix) ? message.substr(prefix.size()) : message);
}

std::shared_ptr<void> openLibrary(const std::filesystem::path& file) {
    void* handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle) return nullptr;
    return {handle, [](void* library) { ::dlclose(library); }};
}

void judge(PluginReport& report, PluginState state, std::string detail) {
    report.state = state;
    report.detail = std::move(detail);
}

// A plugin must not throw; where it does all the same, that is its refusal and not the end of the process.
const candela_plugin* queried(candela_plugin_query_function query, PluginReport& report) {
    try {
        const candela_plugin* description = query(CANDELA_PLUGIN_MAJOR, CANDELA_PLUGIN_MINOR);
        if (!description)
            judge(report, PluginState::refused,
                  joined("candela_plugin_query returned NULL for version ", CANDELA_PLUGIN_MAJOR, ".",
                         CANDELA_PLUGIN_MINOR));
        return description;
    } catch (...) {
        judge(report, PluginState::refused, "candela_plugin_query threw an exception");
        return nullptr;
    }
}

}  // namespace

PluginFile openPluginFile(const std::filesystem::path& file) {
    PluginFile result;
    result.report.file = file;
    auto loaded = std::make_shared<LoadedPlugin>();
    loaded->library = openLibrary(file);
    if (!loaded->library) {
        judge(result.report, PluginState::notALibrary, loaderMessage(file));
        return result;
    }
    void* symbol = ::dlsym(loaded->library.get(), "candela_plugin_query");
    if (!symbol) {
        judge(result.report, PluginState::noEntryPoint, "it does not export candela_plugin_query");
        return result;
    }
    const auto query = reinterpret_cast<candela_plugin_query_function>(symbol);
    const candela_plugin* description = queried(query, result.report);
    if (!description) return result;
    checkDescription(description, *loaded, result.report);
    if (result.report.state == PluginState::loaded) result.loaded = std::move(loaded);
    return result;
}

}  // namespace candela
