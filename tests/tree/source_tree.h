#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace candela {

/// The regular files below `folder` with one of the endings (such as ".h"; none: every file), sorted. Hidden
/// folders and build folders are skipped; a folder that does not exist has no files.
std::vector<std::filesystem::path> filesBelow(const std::filesystem::path& folder,
                                              const std::vector<std::string>& endings);

std::vector<std::string> readLines(const std::filesystem::path& file);

/// An `#include` line.
struct Include {
    std::size_t line = 0;  ///< Counted from 1.
    std::string name;      ///< The text between the quotes or brackets; a macro's name as it is.
    bool quoted = false;
};

std::vector<Include> includesOf(const std::filesystem::path& file);

}  // namespace candela
