#include "image_files.h"

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

namespace {

void append(Bytes& out, const Bytes& bytes) {
    out.insert(out.end(), bytes.begin(), bytes.end());
}

/// A Huffman table (ITU-T T.81, B.2.4.2) with one code, the bit 0, that stands for `symbol`.
void appendHuffmanTable(Bytes& out, std::uint8_t classAndSlot, std::uint8_t symbol) {
    append(out, {0xFF, 0xC4, 0, 20, classAndSlot, 1});
    out.resize(out.size() + 15);  // no codes of 2 to 16 bits
    out.push_back(symbol);
}

}  // namespace

Bytes makeGreyJpeg() {
    Bytes out{0xFF, 0xD8};
    append(out, {0xFF, 0xDB, 0, 67, 0});  // quantisation table 0: all ones
    out.resize(out.size() + 64, 1);
    append(out, {0xFF, 0xC0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0});  // baseline, 8 × 8, one component
    appendHuffmanTable(out, 0x00, 10);                               // DC: a difference of 10 bits
    appendHuffmanTable(out, 0x10, 0);                                // AC: end of block
    append(out, {0xFF, 0xDA, 0, 8, 1, 1, 0x00, 0, 63, 0});
    // The bits 0, 1000000000, 0 and padding of ones: a DC of 512 is 64 above the middle grey 128.
    append(out, {0x40, 0x0F});
    append(out, {0xFF, 0xD9});
    return out;
}

}  // namespace candela_test
