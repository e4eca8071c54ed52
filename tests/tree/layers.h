#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace candela {

/// Checks every #include of include/, lib/, plugins/ and apps/ of the tree at `root` against the layers
///
///     abi -> base -> scene -> import | color | gl -> render -> apps
///
/// and returns a line for each arrow that points the wrong way: "FILE:LINE: REASON". The rules:
///  - a file sees its own layer and those to its left; import, color and gl do not see each other, and gl
///  does
///    not see scene;
///  - each public header has a layer in the table of layers.cpp, and includes the standard library, GLM and
///    public headers only; plugin.h includes nothing but the C library;
///  - private headers are included as "LAYER/name.h"; of other libraries each layer sees only its own;
///  - a plugin includes candela/plugin.h and its own files, and does not link candela;
///  - an app includes public headers, its own files and those of apps/common.
std::vector<std::string> layerViolations(const std::filesystem::path& root);

/// The public headers that candela/candela.h leaves out.
std::vector<std::string> missingInUmbrella(const std::filesystem::path& root);

}  // namespace candela
