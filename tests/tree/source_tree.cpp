#include "source_tree.h"

#include <algorithm>
#include <fstream>
#include <optional>

namespace candela {

namespace {

namespace fs = std::filesystem;

bool isSkipped(const fs::path& folder) {
    const std::string name = folder.filename().string();
    return name.starts_with(".") || name.starts_with("build");
}

std::optional<Include> includeIn(const std::string& line) {
    const auto skipSpace = [&line](std::size_t at) {
        return std::min(line.find_first_not_of(" \t", at), line.size());
    };
    std::size_t at = skipSpace(0);
    if (at == line.size() || line[at] != '#') return {};
    at = skipSpace(at + 1);
    if (line.compare(at, 7, "include") != 0) return {};
    at = skipSpace(at + 7);
    if (at == line.size()) return {};
    if (line[at] != '<' && line[at] != '"') return Include{0, line.substr(at), false};
    const std::size_t end = line.find(line[at] == '<' ? '>' : '"', at + 1);
    return Include{0, line.substr(at + 1, end - at - 1), line[at] == '"'};
}

}  // namespace

std::vector<fs::path> filesBelow(const fs::path& folder, const std::vector<std::string>& endings) {
    std::vector<fs::path> files;
    if (!fs::is_directory(folder)) return files;
    for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::recursive_directory_iterator();
         ++entry) {
        if (entry->is_directory() && isSkipped(entry->path())) entry.disable_recursion_pending();
        if (!entry->is_regular_file()) continue;
        const std::string name = entry->path().filename().string();
        const bool wanted =
            endings.empty() || std::any_of(endings.begin(), endings.end(),
                                           [&](const std::string& end) { return name.ends_with(end); });
        if (wanted) files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> readLines(const fs::path& file) {
    std::ifstream stream(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::vector<Include> includesOf(const fs::path& file) {
    std::vector<Include> includes;
    const std::vector<std::string> lines = readLines(file);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::optional<Include> include = includeIn(lines[i]);
        if (!include) continue;
        include->line = i + 1;
        includes.push_back(*include);
    }
    return includes;
}

}  // namespace candela
