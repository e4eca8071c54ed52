#include "whole_picture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace {

using namespace std::string_view_literals;

constexpr std::string_view pngStart = "\x89PNG\r\n\x1a\n"sv;
/// The chunk IEND: length 0, name, checksum. Source: PNG specification, 11.2.5.
constexpr std::string_view pngEnd = "\0\0\0\0IEND\xae\x42\x60\x82"sv;
/// Magic number and version 2 of a single-part file of scan lines, whose names have up to 255 bytes or not.
constexpr std::string_view exrStart = "\x76\x2f\x31\x01\x02"sv;

/// A file that is read in pieces; every function fails softly beyond its end.
class Reader {
  public:
    explicit Reader(const std::filesystem::path& path) : stream_(path, std::ios::binary | std::ios::ate) {
        if (stream_) size_ = static_cast<std::uint64_t>(stream_.tellg());
        seek(0);
    }

    std::uint64_t size() const { return size_; }
    void seek(std::uint64_t position) { stream_.seekg(static_cast<std::streamoff>(position)); }
    std::uint64_t position() { return static_cast<std::uint64_t>(stream_.tellg()); }
    bool good() const { return stream_.good(); }

    std::string text(std::size_t bytes) {
        std::string read(bytes, '\0');
        stream_.read(read.data(), static_cast<std::streamsize>(bytes));
        return stream_ ? read : std::string();
    }
    /// Up to the next byte 0.
    std::string name() {
        std::string read;
        std::getline(stream_, read, '\0');
        return read;
    }
    /// A number of the host's byte order, which is that of EXR files.
    template <typename Number>
    std::optional<Number> number() {
        std::array<char, sizeof(Number)> bytes;
        if (!stream_.read(bytes.data(), bytes.size())) return std::nullopt;
        Number value;
        std::memcpy(&value, bytes.data(), bytes.size());
        return value;
    }

  private:
    std::ifstream stream_;
    std::uint64_t size_ = 0;
};

bool isWholePng(Reader& file) {
    if (file.size() < pngStart.size() + pngEnd.size()) return false;
    file.seek(file.size() - pngEnd.size());
    return file.text(pngEnd.size()) == pngEnd;
}

/// Rows that a chunk of an EXR holds, by the number of its compression. Source: OpenEXR file layout, "Chunk
/// Layout".
constexpr std::array rowsOfChunk{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};

/// What of the header says how many chunks there are.
struct ExrLayout {
    int compression = -1;
    std::int64_t rows = 0;
};

/// Reads the attributes, up to the table of chunks. None where they are cut off or say nothing of it.
std::optional<ExrLayout> readHeader(Reader& file) {
    ExrLayout layout;
    for (std::string name = file.name(); file.good(); name = file.name()) {
        if (name.empty()) break;
        file.name();  // The type.
        const auto size = file.number<std::uint32_t>();
        if (!size) return std::nullopt;
        const std::uint64_t next = file.position() + *size;
        if (next > file.size()) return std::nullopt;
        if (name == "compression") layout.compression = file.number<std::uint8_t>().value_or(255);
        if (name == "dataWindow") {
            std::array<std::int64_t, 4> window{};  // Smallest x and y, largest x and y.
            for (std::int64_t& side : window) side = file.number<std::int32_t>().value_or(0);
            layout.rows = window[3] - window[1] + 1;
        }
        file.seek(next);
    }
    const bool known = layout.compression >= 0 && layout.compression < int(rowsOfChunk.size());
    return file.good() && known && layout.rows > 0 ? std::optional(layout) : std::nullopt;
}

bool isWholeExr(Reader& file) {
    file.seek(exrStart.size() + 3);  // Behind the flags.
    const std::optional<ExrLayout> layout = readHeader(file);
    if (!layout) return false;
    const std::int64_t rows = rowsOfChunk[static_cast<std::size_t>(layout->compression)];
    const auto chunks = static_cast<std::uint64_t>((layout->rows + rows - 1) / rows);
    if (chunks * sizeof(std::uint64_t) > file.size() - file.position()) return false;
    std::uint64_t last = 0;
    for (std::uint64_t chunk = 0; chunk < chunks; ++chunk) {
        const std::uint64_t offset = file.number<std::uint64_t>().value_or(0);
        if (offset == 0 || offset >= file.size()) return false;  // A chunk that was never written.
        last = std::max(last, offset);
    }
    // A chunk is its first row, the size of its data, and these.
    file.seek(last + sizeof(std::int32_t));
    const auto size = file.number<std::uint32_t>();
    return size && file.position() + *size == file.size();
}

}  // namespace

bool isWholePicture(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    Reader file(path);
    const std::string start = file.text(pngStart.size());
    if (start == pngStart) return isWholePng(file);
    return start.starts_with(exrStart) && isWholeExr(file);
}
