#pragma once

#include <candela/color.h>
#include <candela/renderer.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// Throws `candela::Error` (environment) when no file can be created at `path`: its folder is missing or not
/// writable, or it is a folder. Called before any drawing.
void checkWritable(const std::filesystem::path& path);

/// Writes `text` into a file that is whole or absent; a device or a pipe is written straight into. Throws
/// `candela::Error` (environment).
void writeText(const std::filesystem::path& path, const std::string& text);

/// Writes a displayed frame into an 8-bit PNG, opaque everywhere. The file is whole or absent, also when a
/// signal ends the program.
void writeDisplayedFrame(const std::filesystem::path& path, int width, int height,
                         std::vector<std::uint8_t> rgba, const candela::DisplayTransform& display);

/// Writes radiance and AOVs into an EXR, whole or absent likewise.
void writeRadiance(const std::filesystem::path& path, const candela::HdrImage& radiance,
                   const std::vector<candela::Aov>& aovs, const candela::ColorConfig& color,
                   const std::vector<candela::ExrAttribute>& attributes = {});
