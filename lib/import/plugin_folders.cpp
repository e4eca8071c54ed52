#include "import/plugin_folders.h"

#include "import/text.h"

#include <candela/error.h>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace candela {
namespace fs = std::filesystem;
namespace {

constexpr const char* environmentName = "CANDELA_PLUGIN_PATH";
constexpr const char* folderName = "candela-plugins";

// Empty parts, which elsewhere mean the working directory, are skipped: it is never searched.
std::vector<fs::path> environmentFolders() {
    std::vector<fs::path> folders;
    const char* value = std::getenv(environmentName);
    std::istringstream parts(value ? value : "");
    for (std::string part; std::getline(parts, part, ':');)
        if (!part.empty()) folders.emplace_back(part);
    return folders;
}

// The file of the library or program with this function, from the memory map of the process: dladdr gives the
// name that the library was opened with, which may be relative to an earlier working directory.
std::optional<fs::path> libraryFile() {
    const auto here = reinterpret_cast<std::uintptr_t>(&libraryFile);
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        std::uintptr_t begin = 0, end = 0;
        if (std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR, &begin, &end) != 2) continue;
        if (here < begin || here >= end) continue;
        const std::size_t path = line.find('/');
        if (path == std::string::npos) return std::nullopt;
        return fs::path(line.substr(path));
    }
    return std::nullopt;
}

std::vector<fs::path> standardFolders() {
    std::vector<fs::path> folders;
    if (const auto library = libraryFile()) folders.push_back(library->parent_path() / folderName);
    folders.emplace_back(CANDELA_INSTALL_PLUGIN_FOLDER);
    return folders;
}

[[noreturn]] void failOn(const fs::path& folder, const std::string& text) {
    throw Error(ErrorKind::environment, folder.string(), text);
}

void addFolder(const fs::path& folder, std::vector<fs::path>& order) {
    std::error_code error;
    fs::path canonical = fs::canonical(folder, error);
    if (error) failOn(folder, "this plugin folder can not be reached: " + error.message());
    if (std::find(order.begin(), order.end(), canonical) == order.end())
        order.push_back(std::move(canonical));
}

void addExistingFolder(const fs::path& folder, const std::string& source, std::vector<fs::path>& order) {
    std::error_code error;
    const fs::file_status status = fs::status(folder, error);
    if (status.type() == fs::file_type::not_found) failOn(folder, "there is no such plugin folder" + source);
    if (status.type() == fs::file_type::none) failOn(folder, error.message() + source);
    if (!fs::is_directory(status))
        failOn(folder, "a plugin folder was expected, but this is no folder" + source);
    addFolder(folder, order);
}

}  // namespace

PluginFolders processPluginFolders(const std::vector<fs::path>& given) {
    return {given, environmentFolders(), standardFolders()};
}

std::vector<fs::path> searchOrder(const PluginFolders& folders) {
    std::vector<fs::path> order;
    for (const fs::path& folder : folders.given) addExistingFolder(folder, "", order);
    for (const fs::path& folder : folders.environment)
        addExistingFolder(folder, joined(" (named in ", environmentName, ")"), order);
    for (const fs::path& folder : folders.standard) {
        std::error_code ignored;
        if (fs::is_directory(folder, ignored)) addFolder(folder, order);
    }
    return order;
}

std::vector<fs::path> pluginFilesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        std::error_code ignored;
        if (entry->path().extension() == ".so" && entry->is_regular_file(ignored))
            files.push_back(entry->path());
    }
    if (error) failOn(folder, "this plugin folder can not be read: " + error.message());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace candela
