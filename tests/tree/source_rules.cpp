#include "source_rules.h"

#include "source_tree.h"

#include <algorithm>
#include <cctype>
#include <regex>

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

// Whether `line` contains `word` as a whole word. A word that follows one of the characters `joins` is part
// of a longer path.
bool containsWord(const std::string& line, const std::string& word, const std::string& joins) {
    for (std::size_t at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool starts =
            at == 0 || (!isWordCharacter(line[at - 1]) && joins.find(line[at - 1]) == std::string::npos);
        const bool ends = word.back() == '/' || end == line.size() || !isWordCharacter(line[end]);
        if (starts && ends) return true;
    }
    return false;
}

std::string lowerCase(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string placeOf(const fs::path& root, const fs::path& file, std::size_t line) {
    return file.lexically_relative(root).generic_string() + ":" + std::to_string(line) + ": ";
}

/// The documents, without CHANGELOG.md, which describes earlier states in their words.
std::vector<fs::path> documents(const fs::path& root) {
    std::vector<fs::path> files = filesBelow(root / "docs", {".md"});
    for (const char* name : {"README.md", "CONTRIBUTING.md"})
        if (fs::is_regular_file(root / name)) files.push_back(root / name);
    return files;
}

/// Whether a code span names a file or folder of the tree, such as `lib/gl/egl.cpp`.
bool namesFile(const std::string& span) {
    static const std::vector<std::string> folders = {"include/", "lib/",   "shaders/", "plugins/", "apps/",
                                                     "python/",  "tests/", "cmake/",   "scripts/", "docs/"};
    const bool plain =
        span.find_first_of(" *<>{}()$?:") == std::string::npos && span.find("NAME") == std::string::npos;
    return plain &&
           std::ranges::any_of(folders, [&](const std::string& folder) { return span.starts_with(folder); });
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
    for (const char* folder : {"include", "lib", "shaders", "plugins", "apps", "python", "tests", "cmake"}) {
        append(files, filesBelow(root / folder, endings));
    }
    for (const char* folder : {"scripts", ".ci"}) append(files, filesBelow(root / folder, {}));
    for (const char* name : {"CMakeLists.txt", "CMakePresets.json", "pyproject.toml"}) {
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
                if (containsWord(lines[i], mark, ""))
                    violations.push_back(place + "a note of unfinished work, " + mark);
            }
            for (const std::string& folder : personalFolders) {
                if (containsWord(lines[i], folder, "./-}"))
                    violations.push_back(place + "a path of one machine, " + folder);
            }
        }
        if (lines.size() <= maxLines || name.ends_with("candela/plugin.h")) continue;
        violations.push_back(name + ":" + std::to_string(lines.size()) + ": more than " +
                             std::to_string(maxLines) + " lines");
    }
    return violations;
}

std::vector<BannedWord> readBannedWords(const fs::path& file) {
    std::vector<BannedWord> words;
    for (const std::string& line : readLines(file)) {
        const std::size_t equals = line.find(" = ");
        if (line.starts_with('#') || equals == std::string::npos) continue;
        words.push_back({line.substr(0, equals), line.substr(equals + 3)});
    }
    return words;
}

std::vector<std::string> wordViolations(const fs::path& root, const std::vector<BannedWord>& words) {
    std::vector<std::string> violations;
    std::vector<fs::path> files = sourceFiles(root);
    append(files, documents(root));
    for (const fs::path& file : files) {
        // Copies of the plugin interface as it was.
        if (file.generic_string().find("/fixtures/abi_") != std::string::npos) continue;
        const std::vector<std::string> lines = readLines(file);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::string line = lowerCase(lines[i]);
            for (const BannedWord& word : words) {
                if (!containsWord(line, word.word, "")) continue;
                violations.push_back(placeOf(root, file, i + 1) + "\"" + word.word + "\"; say " +
                                     word.replacement);
            }
        }
    }
    return violations;
}

std::vector<std::string> missingFilesOfDocuments(const fs::path& root) {
    std::vector<std::string> violations;
    for (const fs::path& file : documents(root)) {
        const std::vector<std::string> lines = readLines(file);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            std::size_t begin = lines[i].find('`');
            while (begin != std::string::npos) {
                const std::size_t end = lines[i].find('`', begin + 1);
                if (end == std::string::npos) break;
                const std::string span = lines[i].substr(begin + 1, end - begin - 1);
                if (namesFile(span) && !fs::exists(root / span) && !fs::exists(root / "shaders" / span))
                    violations.push_back(placeOf(root, file, i + 1) + "there is no " + span);
                begin = lines[i].find('`', end + 1);
            }
        }
    }
    return violations;
}

std::vector<std::string> structsNotInitialized(const fs::path& root) {
    std::string program;
    for (const std::string& line : readLines(root / "tests/tree/designated_initializers.cpp"))
        program += line + "\n";
    const auto initialized = [&](const std::string& name) {
        return std::regex_search(program, std::regex("\\b" + name + "(<float>)?\\{\\."));
    };
    const std::regex declaration("\\s*struct (CANDELA_API )?(\\w+) \\{");
    std::vector<std::string> violations;
    for (const fs::path& file : filesBelow(root / "include/candela", {".h"})) {
        const std::vector<std::string> lines = readLines(file);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            std::smatch match;
            if (!std::regex_match(lines[i], match, declaration)) continue;
            const std::string name = match[2];
            if (name != "Handle" && !initialized(name))
                violations.push_back(placeOf(root, file, i + 1) + name + " is not initialised");
        }
    }
    return violations;
}

double shortFileShare(const fs::path& root) {
    std::size_t shortFiles = 0, all = 0;
    for (const char* folder : {"include", "lib", "plugins", "apps"}) {
        const std::vector<fs::path> files = filesBelow(root / folder, {".h", ".cpp"});
        all += files.size();
        shortFiles += static_cast<std::size_t>(std::ranges::count_if(
            files, [](const fs::path& file) { return readLines(file).size() < minLines; }));
    }
    return all == 0 ? 0.0 : static_cast<double>(shortFiles) / static_cast<double>(all);
}

}  // namespace candela
