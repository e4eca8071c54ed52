#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace candela_obj {

/// The files that "mtllib" names. A name may hold blanks: it ends with a word that ends in ".mtl", or with
/// the line.
std::vector<std::string> libraryNames(std::string_view rest);

/// A file that `owner` (a path relative to the scene's folder) names: relative to the folder of `owner`, and
/// with '/' in place of '\'.
std::string besideFile(const std::string& owner, std::string_view name);

}  // namespace candela_obj
