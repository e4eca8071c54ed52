#pragma once

#include "encoder_pool.h"
#include "options.h"
#include "picture_file.h"

#include <candela/image_stream.h>
#include <candela/whole_file.h>

#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

/// Encodes a picture while it is drawn, in bands of rows from the top, so that memory never holds all of it:
/// one band is encoded, on a thread of its own, while the next one is drawn. The file is that of
/// `encodePicture`, and is whole or not there.
class BandWriter {
  public:
    /// `path` is empty for standard output. `height` is that of the picture. Throws `candela::Error` as
    /// `candela::WholeFile` does.
    BandWriter(const std::filesystem::path& path, int height, PictureFormat format,
               const EncodingOptions& options);
    BandWriter(const BandWriter&) = delete;
    BandWriter& operator=(const BandWriter&) = delete;

    /// Takes the next rows, `DrawnPicture::height` of them. The first band has what the header says. Waits
    /// for the band before. Throws `candela::Error` as the streams of candela/image_stream.h do, of any band
    /// before.
    void add(DrawnPicture band);
    /// Ends the file, which `finish` puts in its place. Returns its bytes. Throws as `add` does.
    std::uint64_t end();
    /// Puts the file in its place, or writes it onto standard output. Throws as `candela::WholeFile::finish`.
    void finish() { file_.finish(); }
    /// What encoding the bands has taken. Known after `end`.
    double milliseconds() const { return milliseconds_; }

  private:
    void encode(DrawnPicture& band);
    void encodeRadiance(const DrawnPicture& band);
    void requireNoFailure();

    candela::WholeFile file_;
    std::uint32_t height_;
    PictureFormat format_;
    EncodingOptions options_;
    std::optional<candela::PngStream> png_;
    std::optional<candela::ExrStream> exr_;
    double milliseconds_ = 0.0;
    std::mutex failureMutex_;
    std::exception_ptr failure_;
    EncoderPool pool_;  ///< Destroyed first: its jobs use all of the above.
};
