#include "jpeg_file.h"

namespace candela_test {
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
