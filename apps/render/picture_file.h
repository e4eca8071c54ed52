#pragma once

#include "options.h"

#include <candela/frame_data.h>
#include <candela/image_file.h>

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <vector>

/// A picture that has been drawn, in memory.
struct DrawnPicture {
    int width = 0, height = 0;
    /// As the display shows it, for PNG and raw bytes; empty for an EXR.
    std::vector<std::uint8_t> rgba;
    candela::DisplayEncoding encoding;
    /// Scene-linear, for an EXR; empty otherwise.
    candela::HdrImage radiance;
    std::vector<candela::Aov> aovs;
    candela::Chromaticities chromaticities;
    std::vector<candela::ExrAttribute> attributes;

    std::size_t bytes() const;
};

/// The bytes of the picture's file. `name` is what errors name. Throws `candela::Error`.
std::vector<std::byte> encodePicture(const std::string& name, DrawnPicture picture, PictureFormat format,
                                     const EncodingOptions& options);

/// Standard output, which several threads write pictures to in the order of the pictures.
class OrderedOutput {
  public:
    /// Waits until all pictures before `index` have been written or left out, and writes. Throws
    /// `candela::Error` (environment).
    void write(std::uint64_t index, std::span<const std::byte> bytes);
    /// The same of what `writing` writes.
    void write(std::uint64_t index, const std::function<void()>& writing);
    /// Waits likewise and writes nothing.
    void leaveOut(std::uint64_t index);

  private:
    std::mutex mutex_;
    std::condition_variable turned_;
    std::uint64_t turn_ = 0;
};
