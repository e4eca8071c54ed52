#pragma once

#include <candela/color.h>
#include <candela/image_file.h>
#include <candela/renderer.h>

#include <cstddef>
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

/// Sets every alpha to 255.
void makeOpaque(std::vector<std::uint8_t>& rgba);

/// Writes a displayed frame into an 8-bit PNG, opaque everywhere. The file is whole or absent, also when a
/// signal ends the program.
void writeDisplayedFrame(const std::filesystem::path& path, int width, int height,
                         std::vector<std::uint8_t> rgba, const candela::DisplayTransform& display);

/// How an EXR of radiance and AOVs is encoded.
struct RadianceEncoding {
    /// Of the channels that are no depth, position or count: `half` would lose what these are for.
    candela::ExrPixelType pixels = candela::ExrPixelType::float32;
    candela::ExrOptions exr = {};
};

/// Radiance and AOVs as an EXR. `name` is what errors name. Throws as `candela::encodeExr`.
std::vector<std::byte> encodeRadiance(const std::string& name, const candela::HdrImage& radiance,
                                      const std::vector<candela::Aov>& aovs,
                                      const candela::Chromaticities& chromaticities,
                                      const std::vector<candela::ExrAttribute>& attributes,
                                      const RadianceEncoding& encoding = {});

/// Writes it into a file, whole or absent as of `writeDisplayedFrame`.
void writeRadiance(const std::filesystem::path& path, const candela::HdrImage& radiance,
                   const std::vector<candela::Aov>& aovs, const candela::ColorConfig& color,
                   const std::vector<candela::ExrAttribute>& attributes = {});
