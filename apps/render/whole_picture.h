#pragma once

#include <filesystem>

/// Whether a file is a PNG or an EXR of which nothing is missing: it begins as one, and it ends where its
/// last chunk ends. The pixels are not decoded. Files that candela writes are whole or not there; others,
/// such as those of an interrupted copy, may not be.
bool isWholePicture(const std::filesystem::path& path);
