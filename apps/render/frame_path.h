#pragma once

#include "options.h"

#include <filesystem>

/// The name of a frame's picture. A run of '#' in the file's name becomes the frame number, padded with
/// zeros; without one, and with more than one frame, the number goes before the ending.
std::filesystem::path framePath(const std::filesystem::path& output, const FrameRange& frames, int frame);
