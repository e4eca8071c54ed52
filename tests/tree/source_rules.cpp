#include "source_rules.h"

#include "source_tree.h"

#include <cctype>

namespace candela {

namespace {

namespace fs = std::filesystem;

// Split, so that this file does not break the rules it checks.
const std::vector<std::string> unfinished = {
    "TO"
    "DO",
    "FIX"
    "ME",
    "XX"
    "X"};
const std::vector<std::string> personalFolders = {
    "/ho"
    "me/",
    "/ro"
    "ot/",
    "/Us"
    "ers/",
    "/wo"
    "rk/"};

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Whether `line` holds `word` with nothing before it that would make it part of a longer name or path.
bool holds(const std::string& line, const std::string& word, const std::string& joins) {
    for (std::size_t at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool starts =
            at == 0 || (!isWordCharacter(line[at - 1]) && joins.find(line[at - 1]) == std::string::npos);
        const bool ends = word.back() == '/' || end == line.size() || !isWordCharacter(line[end]);
        if (starts && ends) return true;
    }
    return false;
}

void append(std::vector<fs::path>& files, std::vector<fs::path> more) {
    files.insert(files.end(), more.begin(), more.end());
}

}  // namespace

std::vector<fs::path> sourceFiles(const fs::path& root) {
    const std::vector<std::string> endings = {
        ".h",    ".cpp",  ".c",  ".in", ".glsl",  ".vert",         ".geom",
        ".frag", ".comp", ".py", ".sh", ".cmake", "CMakeLists.txt"};
    std::vector<fs::path> files;
    for (const char* folder : {"include", "lib", "shaders", "plugins", "apps", "tests", "cmake"}) {
        append(files, filesBelow(root / folder, endings));
    }
    for (const char* folder : {"scripts", ".ci"}) append(files, filesBelow(root / folder, {}));
    for (const char* name : {"CMakeLists.txt", "CMakePresets.json"}) {
        if (fs::is_regular_file(root / name)) files.push_back(root / name);
    }
    return files;
}

std::vector<std::string> sourceViolations(const fs::path& root) {
    std::vector<std::string> violations;
    for (const fs::path& file : sourceFiles(root)) {
        const std::string name = file.lexically_relative(root).generic_string();
        const std::vector<std::string> lines = readLines(file);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::string place = name + ":" + std::to_string(i + 1) + ": ";
            for (const std::string& mark : unfinished) {
                if (holds(lines[i], mark, ""))
                    violations.push_back(place + "a note of unfinished work, " + mark);
            }
            for (const std::string& folder : personalFolders) {
                if (holds(lines[i], folder, "./-}"))
                    violations.push_back(place + "a path of one machine, " + folder);
            }
        }
        if (lines.size() <= maxLines) continue;
        violations.push_back(name + ":" + std::to_string(lines.size()) + ": more than " +
                             std::to_string(maxLines) + " lines");
    }
    return violations;
}

}  // namespace candela
