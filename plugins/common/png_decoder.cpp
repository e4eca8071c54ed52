#include <png.h>

#include <bit>
#include <cstdio>
#include <cstring>

#include "image.h"

namespace candela_plugins {
namespace {

/// libpng reports errors by longjmp, which must not skip destructors: the functions that call setjmp hold no
/// object that has one.
class PngReader {
  public:
    explicit PngReader(const Bytes& file) : file_(file) {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, onError, onWarning);
        if (png_) info_ = png_create_info_struct(png_);
        if (!info_) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw std::bad_alloc();
        }
        png_set_read_fn(png_, this, readBytes);
    }
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    /// False after an error; see `message`.
    bool readHeader() {
        if (setjmp(png_jmpbuf(png_))) return false;
        // `decodePng` has a limit of its own, and says so.
        png_set_user_limits(png_, 0x7FFFFFFF, 0x7FFFFFFF);
        png_read_info(png_, info_);
        storedBytes_ = std::uint64_t(png_get_rowbytes(png_, info_)) * png_get_image_height(png_, info_);
        convertToRgba();
        passes_ = png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }

    bool readRows(std::uint8_t* pixels) {
        if (setjmp(png_jmpbuf(png_))) return false;
        const std::size_t rowSize = png_get_rowbytes(png_, info_);
        for (int pass = 0; pass < passes_; ++pass) {
            for (std::uint32_t y = 0; y < height(); ++y) png_read_row(png_, pixels + y * rowSize, nullptr);
        }
        png_read_end(png_, nullptr);
        return true;
    }

    std::uint32_t width() const { return png_get_image_width(png_, info_); }
    std::uint32_t height() const { return png_get_image_height(png_, info_); }
    SampleSize sampleSize() const {
        return png_get_bit_depth(png_, info_) == 16 ? SampleSize::bits16 : SampleSize::bits8;
    }
    std::size_t decodedBytes() const { return png_get_rowbytes(png_, info_) * height(); }
    /// Of the image data once it is inflated.
    std::uint64_t storedBytes() const { return storedBytes_; }
    const char* message() const { return message_; }

  private:
    void convertToRgba() {
        png_set_expand(png_);
        if (!(png_get_color_type(png_, info_) & PNG_COLOR_MASK_COLOR)) png_set_gray_to_rgb(png_);
        if (std::endian::native == std::endian::little) png_set_swap(png_);
        png_set_add_alpha(png_, 0xFFFF, PNG_FILLER_AFTER);
    }

    static void onError(png_structp png, png_const_charp text) {
        auto& reader = *static_cast<PngReader*>(png_get_error_ptr(png));
        std::snprintf(reader.message_, sizeof reader.message_, "%s", text);
        png_longjmp(png, 1);
    }

    static void onWarning(png_structp, png_const_charp) {}

    static void readBytes(png_structp png, png_bytep to, std::size_t count) {
        auto& reader = *static_cast<PngReader*>(png_get_io_ptr(png));
        if (count > reader.file_.size - reader.position_) png_error(png, "it is cut off");
        std::memcpy(to, reader.file_.data + reader.position_, count);
        reader.position_ += count;
    }

    Bytes file_;
    std::uint64_t position_ = 0, storedBytes_ = 0;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    int passes_ = 1;
    char message_[128] = "";
};

[[noreturn]] void fail(const PngReader& reader, const std::string& element) {
    throw Failure{element, "the PNG file is broken: " + readable(reader.message())};
}

}  // namespace

bool isPng(const Bytes& file) {
    return file.size >= 8 && png_sig_cmp(const_cast<std::uint8_t*>(file.data), 0, 8) == 0;
}

std::uint64_t decodedPngSize(const Bytes& file) {
    PngReader reader(file);
    return reader.readHeader() ? reader.decodedBytes() : 0;
}

Image decodePng(const Bytes& file, const std::string& element) {
    PngReader reader(file);
    if (!reader.readHeader()) fail(reader, element);
    if (reader.width() > maxSide || reader.height() > maxSide) {
        throw Failure{element, "the PNG file is wider or higher than " + std::to_string(maxSide)};
    }
    // Deflate packs at most 1032 bytes into one, so no memory is allocated for an image that the file cannot
    // hold.
    constexpr std::uint64_t maxRatio = 1032;
    if (reader.storedBytes() / maxRatio > file.size) {
        throw Failure{element, "the PNG file is broken: it is too short for its width and height"};
    }
    Image image{reader.width(), reader.height(), reader.sampleSize(), {}};
    image.pixels.resize(reader.decodedBytes());
    if (!reader.readRows(image.pixels.data())) fail(reader, element);
    return image;
}

}  // namespace candela_plugins
