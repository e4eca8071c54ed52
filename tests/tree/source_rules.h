#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace candela {

/// One idea a file: more lines than this are more than one.
constexpr std::size_t maxLines = 420;

/// The source files of the tree at `root`: code, shaders, scripts and CMake files.
std::vector<std::filesystem::path> sourceFiles(const std::filesystem::path& root);

/// A line, "FILE:LINE: REASON", for each file of more than `maxLines` lines, each note of unfinished work,
/// and each path of a developer's own machine in the source files.
std::vector<std::string> sourceViolations(const std::filesystem::path& root);

}  // namespace candela
