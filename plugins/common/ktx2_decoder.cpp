#include <basisu_transcoder.h>

#include <algorithm>
#include <limits>
#include <mutex>

#include "image.h"

namespace candela_plugins {
namespace {

[[noreturn]] void fail(const std::string& element, const char* reason) {
    throw Failure{element, std::string("the KTX2 file ") + reason};
}

void createTables() {
    static std::once_flag once;
    std::call_once(once, basist::basisu_transcoder_init);
}

/// The header of a file; false where it cannot be read, or is of a kind that Basis Universal does not have.
bool open(basist::ktx2_transcoder& transcoder, const Bytes& file) {
    createTables();
    return file.size <= std::numeric_limits<std::uint32_t>::max() &&
           transcoder.init(file.data, static_cast<std::uint32_t>(file.size));
}

}  // namespace

std::uint64_t decodedKtx2Size(const Bytes& file) {
    basist::ktx2_transcoder transcoder;
    return open(transcoder, file) ? std::uint64_t(transcoder.get_width()) * transcoder.get_height() * 4 : 0;
}

Image decodeKtx2(const Bytes& file, const std::string& element) {
    basist::ktx2_transcoder transcoder;
    if (!open(transcoder, file))
        fail(element, "is broken, or no picture of Basis Universal, as KHR_texture_basisu asks for");
    const std::uint32_t width = transcoder.get_width(), height = transcoder.get_height();
    if (width > maxSide || height > maxSide) fail(element, "is wider or higher than 32768");
    if (transcoder.get_faces() != 1 || transcoder.get_layers() > 1)
        fail(element, "is a cube map or an array, expected one picture");
    // A block of one colour takes a few bits in a code book, or nothing that Zstandard cannot repeat; a
    // larger picture is believed for its length.
    constexpr std::uint64_t maxTexels = std::uint64_t(4096) * 4096, maxTexelsPerByte = 65536;
    const std::uint64_t texels = std::uint64_t(width) * height;
    if (texels > maxTexels && texels / maxTexelsPerByte > file.size)
        fail(element, "is too short for its width and height");
    Image image{width, height, SampleSize::bits8, {}};
    image.pixels.resize(texels * 4);
    const bool isDecoded =
        transcoder.start_transcoding() &&
        transcoder.transcode_image_level(0, 0, 0, image.pixels.data(), static_cast<std::uint32_t>(texels),
                                         basist::transcoder_texture_format::cTFRGBA32);
    if (!isDecoded) fail(element, "is broken or cut off");
    return image;
}

}  // namespace candela_plugins
