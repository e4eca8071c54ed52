#include "obj_scene.h"

namespace candela_test {
namespace {

std::string writeFiles(const TemporaryFolder& folder, const std::string& text,
                       const std::vector<SideFile>& files) {
    for (const SideFile& file : files) folder.write(file.name, file.content);
    return folder.write("scene.obj", text);
}

}  // namespace

std::string textOf(const Bytes& bytes) {
    return {bytes.begin(), bytes.end()};
}

candela::ImportedScene loadObj(const std::string& text, const std::vector<SideFile>& files,
                               const std::string& query) {
    const TemporaryFolder folder;
    return loadPath(writeFiles(folder, text, files) + query);
}

std::string errorOfObj(const std::string& text, const std::vector<SideFile>& files,
                       const std::string& query) {
    const TemporaryFolder folder;
    const std::string path = writeFiles(folder, text, files) + query;
    const std::string error = errorOfPath(path), beginning = path + ": ";
    return error.starts_with(beginning) ? error.substr(beginning.size()) : error;
}

std::string squareVertices() {
    return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
}

std::string cube() {
    return "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
           "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";
}

}  // namespace candela_test
