#pragma once

#include <filesystem>
#include <string>

/// Throws `candela::Error` (environment) when no file can be made at `path`: its folder is missing or not
/// writable, or a folder stands there. Called before any drawing.
void checkWritable(const std::filesystem::path& path);

/// Writes `text` into a file that is whole or absent; a device or a pipe is written straight into. Throws
/// `candela::Error` (environment).
void writeText(const std::filesystem::path& path, const std::string& text);
