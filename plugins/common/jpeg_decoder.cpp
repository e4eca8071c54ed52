#include <cstdio>  // jpeglib.h needs it

#include <jpeglib.h>

#include <jerror.h>

#include <csetjmp>
#include <cstring>

#include "image.h"

#ifndef JCS_EXTENSIONS
#error "libjpeg-turbo is needed, for JCS_EXT_RGBA"
#endif

namespace candela_plugins {
namespace {

/// libjpeg reports errors through callbacks that must not return, hence the longjmp: the functions that call
/// setjmp hold no object with a destructor.
class JpegReader {
  public:
    explicit JpegReader(const Bytes& file) : file_(file) {
        jpeg_.err = jpeg_std_error(&errors_);
        jpeg_.client_data = this;
        errors_.error_exit = onError;
        errors_.emit_message = onMessage;
    }
    ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    /// False after an error; see `message`.
    bool readHeader() {
        if (setjmp(jump_)) return false;
        jpeg_create_decompress(&jpeg_);
        progress_.progress_monitor = limitScans;
        jpeg_.progress = &progress_;
        jpeg_mem_src(&jpeg_, file_.data, file_.size);
        jpeg_read_header(&jpeg_, TRUE);
        jpeg_.out_color_space = JCS_EXT_RGBA;
        return true;
    }

    bool readRows(std::uint8_t* pixels) {
        if (setjmp(jump_)) return false;
        jpeg_start_decompress(&jpeg_);
        const std::size_t rowSize = std::size_t(jpeg_.output_width) * 4;
        while (jpeg_.output_scanline < jpeg_.output_height) {
            JSAMPROW row = pixels + jpeg_.output_scanline * rowSize;
            jpeg_read_scanlines(&jpeg_, &row, 1);
        }
        jpeg_finish_decompress(&jpeg_);
        return !damaged_;
    }

    std::uint32_t width() const { return jpeg_.image_width; }
    std::uint32_t height() const { return jpeg_.image_height; }
    bool hasFourColors() const {
        return jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK;
    }
    const char* message() const { return message_; }

  private:
    static JpegReader& of(j_common_ptr jpeg) { return *static_cast<JpegReader*>(jpeg->client_data); }

    static void keepMessage(j_common_ptr jpeg) {
        char text[JMSG_LENGTH_MAX];
        jpeg->err->format_message(jpeg, text);
        std::snprintf(of(jpeg).message_, sizeof message_, "%s", text);
    }

    static void onError(j_common_ptr jpeg) {
        keepMessage(jpeg);
        std::longjmp(of(jpeg).jump_, 1);
    }

    /// Warnings have level -1. Those listed mean that a part of the image is missing.
    static void onMessage(j_common_ptr jpeg, int level) {
        if (level >= 0 || of(jpeg).damaged_) return;
        const int code = jpeg->err->msg_code;
        if (code != JWRN_JPEG_EOF && code != JWRN_HIT_MARKER && code != JWRN_HUFF_BAD_CODE) return;
        of(jpeg).damaged_ = true;
        keepMessage(jpeg);
    }

    /// Each scan of a progressive file costs a pass over the whole image and can be a few bytes long.
    static void limitScans(j_common_ptr jpeg) {
        constexpr int maxScans = 100;
        if (!jpeg->is_decompressor) return;
        if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number <= maxScans) return;
        std::snprintf(of(jpeg).message_, sizeof message_, "it has more than %d scans", maxScans);
        std::longjmp(of(jpeg).jump_, 1);
    }

    Bytes file_;
    jpeg_decompress_struct jpeg_{};
    jpeg_error_mgr errors_{};
    jpeg_progress_mgr progress_{};
    std::jmp_buf jump_;
    bool damaged_ = false;
    char message_[JMSG_LENGTH_MAX] = "";
};

[[noreturn]] void fail(const std::string& element, const char* reason) {
    throw Failure{element, "the JPEG file is broken: " + readable(reason)};
}

}  // namespace

bool isJpeg(const Bytes& file) {
    constexpr std::uint8_t signature[] = {0xFF, 0xD8, 0xFF};
    return file.size >= sizeof signature && std::memcmp(file.data, signature, sizeof signature) == 0;
}

std::uint64_t decodedJpegSize(const Bytes& file) {
    JpegReader reader(file);
    return reader.readHeader() ? std::uint64_t(reader.width()) * reader.height() * 4 : 0;
}

Image decodeJpeg(const Bytes& file, const std::string& element) {
    JpegReader reader(file);
    if (!reader.readHeader()) fail(element, reader.message());
    if (reader.hasFourColors())
        throw Failure{element, "the JPEG file has CMYK colours, expected RGB or grey"};
    if (reader.width() > maxSide || reader.height() > maxSide) {
        throw Failure{element, "the JPEG file is wider or higher than " + std::to_string(maxSide)};
    }
    // A block of 8 × 8 texels takes a bit or more, so no memory is allocated for an image that the file
    // cannot hold.
    constexpr std::uint64_t maxTexelsPerByte = 8 * 64;
    const std::uint64_t texels = std::uint64_t(reader.width()) * reader.height();
    if (texels / maxTexelsPerByte > file.size) fail(element, "it is too short for its width and height");
    Image image{reader.width(), reader.height(), SampleSize::bits8, {}};
    image.pixels.resize(texels * 4);
    if (!reader.readRows(image.pixels.data())) fail(element, reader.message());
    return image;
}

}  // namespace candela_plugins
