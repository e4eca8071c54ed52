#pragma once

#include <string>
#include <utility>
#include <vector>

#include "../gltf/loading.h"

namespace candela_test {

/// A file beside "scene.obj".
struct SideFile {
    std::string name, content;
};

std::string textOf(const Bytes& bytes);

/// Writes `text` as an .obj file and imports it; `query` begins with '?', or is empty.
candela::ImportedScene loadObj(const std::string& text, const std::vector<SideFile>& files = {},
                               const std::string& query = "");

/// The message of the error that loading ends in, from behind the file's name on; "" when it succeeds.
std::string errorOfObj(const std::string& text, const std::vector<SideFile>& files = {},
                       const std::string& query = "");

/// A unit square in the plane z = 0, seen from +z, as four "v" lines.
std::string squareVertices();

/// The eight "v" lines and six "f" lines of a cube from -1 to 1.
std::string cube();

}  // namespace candela_test
