#include "import/plugin_file.h"

#include "import/plugin_abi.h"
#include "import/plugin_options.h"
#include "import/plugin_rules.h"
#include "import/text.h"

#include <dlfcn.h>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace candela {

namespace {

constexpr std::size_t maxEndingBytes = 64;
constexpr std::size_t maxListEntries = 64;

bool isLetter(char c) {
    return c >= 'a' && c <= 'z';
}
bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isOneOf(char c, const char* set) {
    return c != '\0' && std::strchr(set, c) != nullptr;
}

std::string checkedExtension(const char* text) {
    const std::string extension = boundedText(text, maxEndingBytes, "a file name ending");
    bool legal = !extension.empty();
    for (const char c : extension) legal = legal && (isLetter(c) || isDigit(c) || isOneOf(c, "-_+"));
    if (!legal)
        throw BrokenRule{joined("the file name ending '", oneLine(extension),
                                "' is not made of a to z, 0 to 9, '-', '_' and '+' alone")};
    return extension;
}

std::string checkedScheme(const char* text) {
    const std::string scheme = boundedText(text, maxEndingBytes, "a scheme");
    bool legal = scheme.size() >= 2 && isLetter(scheme[0]);
    for (const char c : scheme) legal = legal && (isLetter(c) || isDigit(c) || isOneOf(c, "-+."));
    if (!legal)
        throw BrokenRule{joined("the scheme '", oneLine(scheme),
                                "' is not a letter and one or more of a to z, 0 to 9, '-', '+' and '.'")};
    return scheme;
}

template <class Check>
std::vector<std::string> checkedList(const char* const* list, const char* what, Check check) {
    std::vector<std::string> entries;
    if (!list) return entries;
    for (std::size_t i = 0; list[i]; ++i) {
        if (i == maxListEntries)
            throw BrokenRule{
                joined("it lists more than ", maxListEntries, " ", what, ", or the list has no end")};
        entries.push_back(check(list[i]));
    }
    return entries;
}

template <class T>
T checkedCopy(const T* source, const char* what) {
    const std::optional<T> copy = copyOf(source);
    if (!copy) throw BrokenRule{joined("struct_size of its ", what, " ", sizeFault(source))};
    return *copy;
}

// The version members come first in every version, so they may be read before all others.
std::uint32_t majorOf(const candela_plugin* description) {
    constexpr std::size_t end = offsetof(candela_plugin, minor) + sizeof(description->minor);
    if (structSizeOf(description) < end)
        throw BrokenRule{joined("struct_size of its candela_plugin is ", structSizeOf(description),
                                ", which does not even hold the version")};
    return description->major;
}

void checkImporter(LoadedPlugin& loaded, PluginReport& report) {
    if (!loaded.plugin.importer) return;
    loaded.importer = checkedCopy(loaded.plugin.importer, "candela_importer");
    loaded.importer.struct_size = sizeof loaded.importer;
    report.extensions = checkedList(loaded.importer.extensions, "file name endings", checkedExtension);
    report.schemes = checkedList(loaded.importer.schemes, "schemes", checkedScheme);
    if (!loaded.importer.import_scene) throw BrokenRule{"import_scene of its importer is NULL"};
    if (report.extensions.empty() && report.schemes.empty())
        throw BrokenRule{"its importer takes no file name ending and no scheme"};
    report.options = checkedOptions(loaded.importer);
    loaded.plugin.importer = &loaded.importer;
}

void checkSubdivider(LoadedPlugin& loaded, PluginReport& report) {
    if (!loaded.plugin.subdivider) return;
    loaded.subdivider = checkedCopy(loaded.plugin.subdivider, "candela_subdivider");
    loaded.subdivider.struct_size = sizeof loaded.subdivider;
    if (!loaded.subdivider.refine) throw BrokenRule{"refine of its subdivider is NULL"};
    report.subdivides = true;
    loaded.plugin.subdivider = &loaded.subdivider;
}

void checkImageDecoder(LoadedPlugin& loaded, PluginReport& report) {
    if (!loaded.plugin.image_decoder) return;
    loaded.imageDecoder = checkedCopy(loaded.plugin.image_decoder, "candela_image_decoder");
    loaded.imageDecoder.struct_size = sizeof loaded.imageDecoder;
    if (!loaded.imageDecoder.recognizes || !loaded.imageDecoder.decode)
        throw BrokenRule{"recognizes or decode of its image decoder is NULL"};
    report.decodesImages = true;
    loaded.plugin.image_decoder = &loaded.imageDecoder;
}

}  // namespace

void checkDescription(const candela_plugin* description, LoadedPlugin& loaded, PluginReport& report) {
    try {
        const std::uint32_t major = majorOf(description);
        if (major != CANDELA_PLUGIN_MAJOR) {
            report.state = PluginState::wrongVersion;
            report.detail = joined("it was built for version ", major,
                                   " of the plugin interface; this is version ", CANDELA_PLUGIN_MAJOR);
            return;
        }
        loaded.plugin = checkedCopy(description, "candela_plugin");
        report.name = checkedName(loaded.plugin.name, "its name");
        report.version = checkedLine(loaded.plugin.version, "its version");
        report.description = checkedLine(loaded.plugin.description, "its description");
        loaded.plugin.struct_size = sizeof loaded.plugin;
        if (!loaded.plugin.importer && !loaded.plugin.subdivider && !loaded.plugin.image_decoder)
            throw BrokenRule{"it offers no service: importer, subdivider and image_decoder are NULL"};
        checkImporter(loaded, report);
        checkSubdivider(loaded, report);
        checkImageDecoder(loaded, report);
        report.state = PluginState::loaded;
    } catch (const BrokenRule& broken) {
        report.state = PluginState::badDescription;
        report.detail = broken.text;
    }
}

namespace {

// The loader's messages begin with the file, which the report has in a separate member.
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

void setState(PluginReport& report, PluginState state, std::string detail) {
    report.state = state;
    report.detail = std::move(detail);
}

// A plugin must not throw. An exception that can be caught counts as a refusal.
const candela_plugin* queried(candela_plugin_query_function query, PluginReport& report) {
    try {
        const candela_plugin* description = query(CANDELA_PLUGIN_MAJOR, CANDELA_PLUGIN_MINOR);
        if (!description)
            setState(report, PluginState::refused,
                     joined("candela_plugin_query returned NULL for version ", CANDELA_PLUGIN_MAJOR, ".",
                            CANDELA_PLUGIN_MINOR));
        return description;
    } catch (...) {
        setState(report, PluginState::refused, "candela_plugin_query threw an exception");
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
        setState(result.report, PluginState::notALibrary, loaderMessage(file));
        return result;
    }
    void* symbol = ::dlsym(loaded->library.get(), "candela_plugin_query");
    if (!symbol) {
        setState(result.report, PluginState::noEntryPoint, "it does not export candela_plugin_query");
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
