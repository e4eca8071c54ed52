#pragma once

#include <functional>
#include <string>
#include <vector>

#include "failure.h"
#include "host.h"

namespace candela_plugins {

enum class SampleSize : std::size_t { bits8 = 1, bits16 = 2 };

/// A decoded image: RGBA, rows from the top, tightly packed; 16-bit samples in the machine's byte order.
struct Image {
    std::uint32_t width = 0, height = 0;
    SampleSize sampleSize = SampleSize::bits8;
    std::vector<std::uint8_t> pixels;
};

/// The maximum width and height that the host accepts.
inline constexpr std::uint32_t maxSide = 32768;

// stb_image, the decoder of tinygltf, is not used: Debian's build aborts on some damaged JPEG files, and
// reads damaged PNG files without an error.

bool isPng(const Bytes& file);
bool isJpeg(const Bytes& file);
bool isWebp(const Bytes& file);
bool isKtx2(const Bytes& file);

/// Decodes a PNG file; 16-bit samples are kept, all others become 8 bits. Colour profiles and gamma are
/// ignored, as glTF 2.0, 3.8.3 asks. Throws `Failure` for `element` when the file is damaged or cut off.
Image decodePng(const Bytes& file, const std::string& element);

/// Decodes a JPEG file of grey or colour. Throws `Failure` for `element` when the file is damaged or cut off.
Image decodeJpeg(const Bytes& file, const std::string& element);

/// Decodes a WebP file, lossy or lossless. Throws `Failure` for `element` when the file is damaged, cut off
/// or animated.
Image decodeWebp(const Bytes& file, const std::string& element);

/// Decodes the largest level of a KTX2 file of Basis Universal (KHR_texture_basisu): ETC1S or UASTC. Throws
/// `Failure` for `element` when the file is damaged, cut off or something else, or the build has no decoder.
Image decodeKtx2(const Bytes& file, const std::string& element);

/// The bytes of the decoded image as the header of the file says; 0 where it cannot be read.
std::uint64_t decodedPngSize(const Bytes& file);
std::uint64_t decodedJpegSize(const Bytes& file);
std::uint64_t decodedWebpSize(const Bytes& file);
std::uint64_t decodedKtx2Size(const Bytes& file);
/// The same for any of these formats; 0 for other files.
std::uint64_t decodedSize(const Bytes& file);

/// What a file is of no format that is read, for messages: "a GIF file, expected PNG, JPEG, WebP or KTX2".
std::string otherFormat(const Bytes& file);

/// Decodes a PNG, JPEG, WebP or KTX2 file. Throws `Failure` for `element` when it is none, damaged or cut
/// off.
Image decodeImage(const Bytes& file, const std::string& element);

/// An image to be created and added.
struct ImageJob {
    std::string name;
    std::uint64_t bytes;          ///< The memory that `make` needs, about.
    std::function<Image()> make;  ///< Called on any thread of the host; must not call the host.
};

/// Creates images on all threads of the host, and adds them in order. Returns their indices: -1, and a note,
/// where `make` throws `Failure`. Jobs run in batches of a limited size in memory, which does not depend on
/// the number of threads. Progress goes from `from` to `to`.
std::vector<std::int32_t> addImages(const std::vector<ImageJob>& jobs, const Host& host, double from,
                                    double to);

}  // namespace candela_plugins
