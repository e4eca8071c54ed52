#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../common/host.h"

namespace candela_plugins::obj {

/// A file that an OBJ or MTL file names, as it was found.
struct ReferencedFile {
    std::optional<Bytes> bytes;
    std::string path;    ///< Relative to the scene's folder; empty where it was not found.
    std::string reason;  ///< Why it was not found.
};

/// Finds a file that `owner` (a path relative to the scene's folder) names `name`. It is looked for relative
/// to the folder of `owner`, relative to the scene's folder, and then by its bare name in both: many files
/// hold paths of the machine that they were written on. '\\' separates folders as '/' does, and quotes around
/// the name are no part of it. A file that is found by its bare name is noted for `element`.
ReferencedFile findReferenced(const std::string& owner, std::string_view name, const std::string& element,
                              const Host& host);

/// Whether `name` is empty or a folder such as ".", which some programs write for no file.
bool namesNoFile(std::string_view name);

/// The files that "mtllib" names. A name may hold blanks: it ends with a word that ends in ".mtl", or with
/// the line.
std::vector<std::string> libraryNames(std::string_view rest);

}  // namespace candela_plugins::obj
