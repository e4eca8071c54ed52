#include "loading.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace candela_test {

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "candela-gltf-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make a temporary folder");
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& content) const {
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
    return file.string();
}

std::string TemporaryFolder::write(const std::string& name, const Bytes& content) const {
    return write(name, std::string(content.begin(), content.end()));
}

const candela::PluginRegistry& plugins() {
    static const candela::PluginRegistry registry({CANDELA_TEST_PLUGINS});
    return registry;
}

candela::ImportedScene loadPath(const std::string& path) {
    return candela::importScene(plugins(), path);
}

candela::ImportedScene loadText(const std::string& text) {
    const TemporaryFolder folder;
    return loadPath(folder.write("scene.gltf", text));
}

candela::ImportedScene loadGlb(const Bytes& bytes) {
    const TemporaryFolder folder;
    return loadPath(folder.write("scene.glb", bytes));
}

candela::ImportedScene load(const GltfFile& file) {
    return loadText(file.text());
}

std::string errorOfPath(const std::string& path) {
    try {
        loadPath(path);
        return "";
    } catch (const candela::Error& error) {
        return error.what();
    }
}

std::string errorOfText(const std::string& text) {
    const TemporaryFolder folder;
    return errorOfPath(folder.write("scene.gltf", text));
}

std::string complaintsOf(const GltfFile& file) {
    std::string text = errorOf(file);
    if (!text.empty()) return text;
    for (const candela::ImportNote& note : load(file).report.notes) text += note.line() + "\n";
    return text;
}

std::string strictErrorOfText(const std::string& text) {
    const TemporaryFolder folder;
    try {
        candela::importScene(plugins(), folder.write("scene.gltf", text), {candela::Strictness::strict, {}});
        return "";
    } catch (const candela::Error& error) {
        return error.what();
    }
}

std::string errorOfGlb(const Bytes& bytes) {
    const TemporaryFolder folder;
    return errorOfPath(folder.write("scene.glb", bytes));
}

bool hasNote(const candela::ImportedScene& imported, const std::string& part) {
    for (const candela::ImportNote& note : imported.report.notes) {
        if (note.line().find(part) != std::string::npos) return true;
    }
    return false;
}

}  // namespace candela_test
