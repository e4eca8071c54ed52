#pragma once

#include <candela/color.h>
#include <candela/image_stream.h>
#include <candela/renderer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
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

/// The channels of an EXR of radiance and AOVs, in their order; of the AOVs only the names are read.
std::vector<candela::ExrChannelType> radianceChannels(const std::vector<candela::Aov>& aovs,
                                                      candela::ExrPixelType pixels);

/// The values of these channels: R, G, B and A of the radiance as a plane each, then those of the AOVs, which
/// have to outlive it.
class RadiancePlanes {
  public:
    RadiancePlanes(const candela::HdrImage& radiance, const std::vector<candela::Aov>& aovs);
    RadiancePlanes(const RadiancePlanes&) = delete;
    RadiancePlanes& operator=(const RadiancePlanes&) = delete;

    std::span<const std::span<const float>> values() const { return values_; }

  private:
    std::array<std::vector<float>, 4> planes_;
    std::vector<std::span<const float>> values_;
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
