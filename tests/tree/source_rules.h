#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace candela {

/// The maximum number of lines of a file. The plugin interface, one file by contract, may have more.
constexpr std::size_t maxLines = 420;

/// Files with fewer lines count as short.
constexpr std::size_t minLines = 40;

/// The source files of the tree at `root`: code, shaders, scripts and CMake files.
std::vector<std::filesystem::path> sourceFiles(const std::filesystem::path& root);

/// A line, "FILE:LINE: REASON", for each file of more than `maxLines` lines, each note of unfinished work,
/// and each path of a developer's own machine in the source files.
std::vector<std::string> sourceViolations(const std::filesystem::path& root);

/// A word that the tree does not use, and what it says instead.
struct BannedWord {
    std::string word, replacement;
};

/// Reads lines "WORD = REPLACEMENT"; others are comments.
std::vector<BannedWord> readBannedWords(const std::filesystem::path& file);

/// A line, "FILE:LINE: REASON", for each banned word in the source files and documents, in any case.
std::vector<std::string> wordViolations(const std::filesystem::path& root,
                                        const std::vector<BannedWord>& words);

/// A line for each file of the tree that a document names in a code span and that does not exist.
std::vector<std::string> missingFilesOfDocuments(const std::filesystem::path& root);

/// A line for each struct of the public headers that tests/tree/designated_initializers.cpp does not
/// initialise by the name of a member. `Handle`, which has constructors, is no aggregate.
std::vector<std::string> structsNotInitialized(const std::filesystem::path& root);

/// The share of files that are short today. It may fall, and must not grow.
constexpr double maxShortFileShare = 0.22;

/// The share of files of fewer than `minLines` lines in include, lib, plugins and apps.
double shortFileShare(const std::filesystem::path& root);

}  // namespace candela
