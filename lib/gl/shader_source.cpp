#include "gl/shader_source.h"

#include <candela/error.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

namespace candela::gl {

namespace {

std::string readFromFolder(const std::string& folder, const std::string& name) {
    const std::string path = folder + "/" + name;
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf())) {
        throw Error(ErrorKind::environment, path,
                    "this shader can not be read; CANDELA_SHADER_DIR has to name a copy of shaders/");
    }
    return text.str();
}

/// The file name of a line `#include "NAME"`; empty for any other line.
std::string includedName(std::string_view line) {
    constexpr std::string_view directive = "#include \"";
    if (!line.starts_with(directive)) return {};
    line.remove_prefix(directive.size());
    return std::string(line.substr(0, line.find('"')));
}

void append(std::string& text, const std::string& name, std::set<std::string>& seen) {
    if (!seen.insert(name).second) return;
    std::istringstream lines(readShader(name));
    for (std::string line; std::getline(lines, line);) {
        const std::string included = includedName(line);
        if (!included.empty()) {
            append(text, included, seen);
        } else {
            text += line + '\n';
        }
    }
}

}  // namespace

std::string readShader(const std::string& name) {
    if (const char* folder = std::getenv("CANDELA_SHADER_DIR")) return readFromFolder(folder, name);
    const auto shaders = embeddedShaders();
    const auto found = std::ranges::find(shaders, std::string_view(name), &EmbeddedShader::name);
    if (found == shaders.end())
        throw Error(ErrorKind::environment, name, "candela has no shader of this name");
    return std::string(found->text);
}

std::string assembleShader(const std::string& name, const std::vector<std::string>& definitions) {
    std::string text = "#version 450 core\n";
    for (const std::string& definition : definitions) text += "#define " + definition + '\n';
    std::set<std::string> seen;
    append(text, name, seen);
    return text;
}

}  // namespace candela::gl
