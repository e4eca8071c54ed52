#include "png_file.h"

#include <algorithm>

namespace candela_test {
namespace {

void appendBig32(Bytes& out, std::size_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::uint32_t crc32(const Bytes& bytes) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = crc & 1u ? crc >> 1 ^ 0xEDB88320u : crc >> 1;
    }
    return ~crc;
}

std::uint32_t adler32(const Bytes& bytes) {
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : bytes) {
        a = (a + byte) % 65521u;
        b = (b + a) % 65521u;
    }
    return b << 16 | a;
}

void appendChunk(Bytes& out, const char* type, const Bytes& data) {
    Bytes body(type, type + 4);
    body.insert(body.end(), data.begin(), data.end());
    appendBig32(out, data.size());
    out.insert(out.end(), body.begin(), body.end());
    appendBig32(out, crc32(body));
}

/// A zlib stream of stored blocks.
Bytes stored(const Bytes& data) {
    Bytes out{0x78, 0x01};
    constexpr std::size_t largest = 65535;
    for (std::size_t i = 0; i < data.size(); i += largest) {
        const std::size_t size = std::min(largest, data.size() - i);
        out.push_back(i + size == data.size() ? 1 : 0);
        for (const std::size_t value : {size, ~size}) {
            out.push_back(static_cast<std::uint8_t>(value));
            out.push_back(static_cast<std::uint8_t>(value >> 8));
        }
        out.insert(out.end(), data.begin() + static_cast<std::ptrdiff_t>(i),
                   data.begin() + static_cast<std::ptrdiff_t>(i + size));
    }
    appendBig32(out, adler32(data));
    return out;
}

}  // namespace

Bytes makePng(std::uint32_t width, std::uint32_t height, int bitDepth, PngColor color, const Bytes& samples) {
    Bytes header;
    appendBig32(header, width);
    appendBig32(header, height);
    header.insert(header.end(),
                  {static_cast<std::uint8_t>(bitDepth), static_cast<std::uint8_t>(color), 0, 0, 0});
    Bytes rows;
    const std::size_t rowSize = samples.size() / height;
    for (std::size_t y = 0; y < height; ++y) {
        rows.push_back(0);  // no filter
        rows.insert(rows.end(), samples.begin() + static_cast<std::ptrdiff_t>(y * rowSize),
                    samples.begin() + static_cast<std::ptrdiff_t>((y + 1) * rowSize));
    }
    Bytes out{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    appendChunk(out, "IHDR", header);
    appendChunk(out, "IDAT", stored(rows));
    appendChunk(out, "IEND", {});
    return out;
}

Bytes makePng(std::uint32_t width, std::uint32_t height, std::uint8_t r, std::uint8_t g, std::uint8_t b,
              std::uint8_t a) {
    Bytes samples;
    for (std::uint32_t i = 0; i < width * height; ++i) samples.insert(samples.end(), {r, g, b, a});
    return makePng(width, height, 8, PngColor::rgba, samples);
}

}  // namespace candela_test
