#include <candela/error.h>

#include "base/hdr_decoders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

// The picture format of Radiance: G. Ward, "Real Pixels", Graphics Gems II, 1991, and the Radiance reference,
// "Radiance file formats".

namespace candela {
namespace {

class RadianceDecoder {
  public:
    RadianceDecoder(std::span<const std::byte> file, const std::string& path) : file_(file), path_(path) {}

    Image decode() {
        readHeader();
        readSize();
        std::vector<std::uint8_t> texels;  // it grows with what the file has
        for (std::uint32_t i = 0; i < lines_; ++i) readLine(texels);
        Image image{"", width_, height_, PixelFormat::rgba32f, {}};
        image.pixels.resize(std::size_t{width_} * height_ * texelSize(image.format));
        auto* const numbers = reinterpret_cast<float*>(image.pixels.data());
        for (std::uint32_t line = 0; line < lines_; ++line) {
            for (std::uint32_t at = 0; at < lineLength_; ++at)
                setTexel(numbers + 4 * place(line, at), &texels[4 * (std::size_t{line} * lineLength_ + at)]);
        }
        convertToRec709(image, primaries_, path_);
        return image;
    }

  private:
    [[noreturn]] void fail(const std::string& reason) const {
        throw Error(ErrorKind::badInput, path_, reason);
    }
    std::uint8_t byte() {
        if (at_ == file_.size()) fail("ends within its pixels");
        return std::to_integer<std::uint8_t>(file_[at_++]);
    }
    std::string headerLine() {
        std::string line;
        while (at_ < file_.size()) {
            const char c = static_cast<char>(file_[at_++]);
            if (c == '\n') return line;
            line += c;
        }
        fail("its header has no end: an empty line and a line such as -Y 512 +X 1024 were expected");
    }

    static std::istringstream fields(const std::string& text) {
        std::istringstream stream(text);
        stream.imbue(std::locale::classic());
        return stream;
    }
    void readHeader() {
        for (std::string line = headerLine(); !line.empty(); line = headerLine()) {
            const std::size_t equals = std::min(line.find('='), line.size());
            const std::string name = line.substr(0, equals);
            std::istringstream value = fields(line.substr(std::min(equals + 1, line.size())));
            std::string format;
            if (name == "FORMAT" && value >> format) {
                if (format == "32-bit_rle_xyze")
                    primaries_ = {{1, 0}, {0, 1}, {0, 0}, {1.0 / 3.0, 1.0 / 3.0}};
                else if (format != "32-bit_rle_rgbe")
                    fail("its FORMAT is neither 32-bit_rle_rgbe nor 32-bit_rle_xyze");
            } else if (name == "EXPOSURE") {
                double exposure = 0.0;
                if (!(value >> exposure) || !(exposure > 0.0)) fail("its EXPOSURE must be a number over 0");
                scale_ /= exposure;
            } else if (name == "PRIMARIES") {
                for (auto* xy : {&primaries_.red, &primaries_.green, &primaries_.blue, &primaries_.white})
                    value >> xy->x >> xy->y;
                if (!value) fail("its PRIMARIES must be 8 numbers");
            }
        }
    }

    /// "-Y 512 +X 1024": lines along X from the top.
    void readSize() {
        std::istringstream text = fields(headerLine());
        std::array<std::string, 2> axes;
        std::array<std::uint32_t, 2> counts{};
        text >> axes[0] >> counts[0] >> axes[1] >> counts[1];
        isColumn_ = axes[0].ends_with('X');
        const std::string &y = axes[isColumn_], &x = axes[!isColumn_];
        if (!text || (y != "-Y" && y != "+Y") || (x != "-X" && x != "+X"))
            fail("its header ends without its size: a line such as -Y 512 +X 1024 was expected");
        fromBottom_ = y == "+Y";
        fromRight_ = x == "-X";
        lines_ = counts[0], lineLength_ = counts[1];
        width_ = counts[!isColumn_], height_ = counts[isColumn_];
        requireHdrSize(path_, width_, height_);
    }
    /// The texel of the picture that a texel of a line is.
    std::size_t place(std::uint32_t line, std::uint32_t at) const {
        const std::uint32_t x = isColumn_ ? line : at, y = isColumn_ ? at : line;
        return std::size_t{fromBottom_ ? height_ - 1 - y : y} * width_ + (fromRight_ ? width_ - 1 - x : x);
    }

    void readLine(std::vector<std::uint8_t>& texels) {
        constexpr std::uint32_t minRun = 8, maxRun = 32767;
        std::array<std::uint8_t, 4> first{byte(), byte(), byte(), byte()};
        const bool isRunCoded = lineLength_ >= minRun && lineLength_ <= maxRun && first[0] == 2 &&
                                first[1] == 2 && first[2] < 128;
        if (!isRunCoded) return readPlainLine(texels, first);
        if ((std::uint32_t{first[2]} << 8 | first[3]) != lineLength_) fail("a line has a wrong length");
        const std::size_t begin = texels.size();
        texels.resize(begin + std::size_t{4} * lineLength_);
        for (std::size_t channel = 0; channel < 4; ++channel) {
            for (std::uint32_t at = 0; at < lineLength_;) {
                const std::uint8_t code = byte();
                const bool isRun = code > 128;
                const std::uint32_t count = isRun ? code & 127u : code;
                if (count == 0 || count > lineLength_ - at) fail("a run of pixels leaves its line");
                const std::uint8_t value = isRun ? byte() : std::uint8_t{0};
                for (const std::uint32_t end = at + count; at < end; ++at)
                    texels[begin + std::size_t{4} * at + channel] = isRun ? value : byte();
            }
        }
    }
    /// Single texels; 1, 1, 1, N repeats the one before N times, and counts that follow have higher digits.
    void readPlainLine(std::vector<std::uint8_t>& texels, std::array<std::uint8_t, 4> texel) {
        const std::size_t begin = texels.size(), end = begin + std::size_t{4} * lineLength_;
        for (int shift = 0;; texel = {byte(), byte(), byte(), byte()}) {
            const bool repeats = texel[0] == 1 && texel[1] == 1 && texel[2] == 1;
            if (!repeats) {
                texels.insert(texels.end(), texel.begin(), texel.end());
                shift = 0;
            } else {
                const std::uint64_t count = shift < 32 ? std::uint64_t{texel[3]} << shift : 0;
                if (texels.size() == begin || count > (end - texels.size()) / 4)
                    fail("a run of pixels leaves its line");
                for (std::uint64_t i = 0; i < 4 * count; ++i) texels.push_back(texels.end()[-4]);
                shift += 8;
            }
            if (texels.size() == end) return;
        }
    }
    /// A mantissa stands for the middle of its step, as in Radiance.
    void setTexel(float* numbers, const std::uint8_t* texel) const {
        const double step = texel[3] == 0 ? 0.0 : std::ldexp(scale_, texel[3] - (128 + 8));
        for (std::size_t i = 0; i < 3; ++i) numbers[i] = static_cast<float>((texel[i] + 0.5) * step);
        numbers[3] = 1.0f;
    }

    std::span<const std::byte> file_;
    const std::string& path_;
    std::size_t at_ = 0;
    double scale_ = 1.0;
    Chromaticities primaries_;
    bool isColumn_ = false, fromBottom_ = false, fromRight_ = false;
    std::uint32_t width_ = 0, height_ = 0, lines_ = 0, lineLength_ = 0;
};

}  // namespace

Image decodeRadiance(std::span<const std::byte> file, const std::string& path) {
    return RadianceDecoder(file, path).decode();
}

}  // namespace candela
