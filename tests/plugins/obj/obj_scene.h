#pragma once

#include <string>
#include <utility>
#include <vector>

#include "../../import/note_lines.h"
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

/// The error message of loading, without the leading file name; "" when loading succeeds.
std::string errorOfObj(const std::string& text, const std::vector<SideFile>& files = {},
                       const std::string& query = "");

/// A unit square in the plane z = 0, seen from +z, as four "v" lines.
std::string squareVertices();

/// The eight "v" lines and six "f" lines of a cube from -1 to 1.
std::string cube();

}  // namespace candela_test
