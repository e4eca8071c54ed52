#pragma once

#include <candela/export.h>
#include <candela/image_file.h>
#include <candela/whole_file.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace candela {

/// Pictures that are written from the top, some rows at a time: memory holds neither picture nor file. The
/// files are those of `encodePng` and `encodeExr`, byte for byte, however the rows are divided. A
/// stream ends with the first error but badInput; after it, after `finish` and after a move its functions
/// throw `Error` (badInput).

/// Whether the pixels of a PNG have alpha.
enum class PngAlpha {
    none,      ///< Alpha is not read: the picture is opaque everywhere.
    straight,  ///< Of a picture that may be opaque nowhere.
};

/// One thread at a time may use it.
class CANDELA_API PngStream {
  public:
    /// Begins a PNG in `file`, which has to outlive the stream. Throws `Error` as `encodePng` and `WholeFile`
    /// do.
    PngStream(WholeFile& file, std::uint32_t width, std::uint32_t height, const DisplayEncoding& encoding,
              PngAlpha alpha, const PngOptions& options = {});
    PngStream(PngStream&&) noexcept;
    PngStream& operator=(PngStream&&) noexcept;
    ~PngStream();

    /// Adds the next rows: 8-bit RGBA. Throws `Error`: badInput when it is no number of whole rows, or more
    /// than are left; environment as `WholeFile::write`.
    void write(std::span<const std::uint8_t> rgba);
    /// Ends the PNG; `WholeFile::finish` may follow. Throws `Error`: badInput when rows are missing;
    /// environment as `WholeFile::write`.
    void finish();

  private:
    struct State;
    State& state() const;

    std::unique_ptr<State> state_;
};

/// A channel of an `ExrStream`.
struct ExrChannelType {
    std::string name = {};
    ExrPixelType type = ExrPixelType::float32;
};

/// One thread at a time may use it.
class CANDELA_API ExrStream {
  public:
    /// Begins an EXR in `file`, which has to outlive the stream. Throws `Error` as `encodeExr` and
    /// `WholeFile` do.
    ExrStream(WholeFile& file, std::uint32_t width, std::uint32_t height,
              std::span<const ExrChannelType> channels, const Chromaticities& chromaticities,
              std::span<const ExrAttribute> attributes = {}, const ExrOptions& options = {});
    ExrStream(ExrStream&&) noexcept;
    ExrStream& operator=(ExrStream&&) noexcept;
    ~ExrStream();

    /// Adds the next rows: the values of each channel in the order of the channels. Throws `Error`: badInput
    /// when these are not as many values for each channel, no number of whole rows, or more than are left;
    /// environment as `WholeFile::write`.
    void write(std::span<const std::span<const float>> values);
    /// As of `PngStream`.
    void finish();

  private:
    struct State;
    State& state() const;

    std::unique_ptr<State> state_;
};

}  // namespace candela
