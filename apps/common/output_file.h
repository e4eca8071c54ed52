#pragma once

#include "options.h"

#include <filesystem>
#include <string>

/// Throws `candela::Error` (environment) when no file can be made at `path`: its folder is missing or not
/// writable, or a folder stands there. Called before any drawing.
void checkWritable(const std::filesystem::path& path);

/// Writes `text` into a file that is whole or absent; a device or a pipe is written straight into. Throws
/// `candela::Error` (environment).
void writeText(const std::filesystem::path& path, const std::string& text);

/// The name of a frame's picture. A run of '#' in the file's name becomes the frame number, padded with
/// zeros; without one, and with more than one frame, the number goes before the ending.
std::filesystem::path framePath(const std::filesystem::path& output, const FrameRange& frames, int frame);
