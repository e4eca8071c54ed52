#include "color/curve_table.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace candela {

namespace {

// 32 pieces an octave: a power, of which display curves are made locally, is met to 1e-4 of its value, which
// is a hundredth of an 8-bit code at most. The first octave begins at `start`, and `start` is added to the
// number before its bits are taken, so that the pieces below it are of one length down to zero.
// The shortest piece is 2^-29 long: there the steepest of the displays' curves, gamma 2.6, rises by a tenth
// of a code.
constexpr float start = 1.0f / 16777216.0f;
constexpr int pieceBits = 18;
constexpr std::int32_t startBits = std::bit_cast<std::int32_t>(start);
constexpr std::int32_t endBits = std::bit_cast<std::int32_t>(CurveTable::end);
constexpr int pieces = (endBits - startBits) >> pieceBits;
constexpr std::int32_t lastBits = (pieces << pieceBits) - 1;

float numberAt(int piece) {
    return std::bit_cast<float>(startBits + (piece << pieceBits)) - start;
}

float slope(const std::vector<float>& row, std::size_t piece) {
    return (row[piece + 1] - row[piece]) * (1.0f / float(1 << pieceBits));
}

}  // namespace

CurveTable::CurveTable(const Function& function) {
    std::vector<Values> values;
    for (int i = 0; i <= pieces; ++i) values.push_back({numberAt(i), numberAt(i), numberAt(i)});
    function(values);
    rows_.resize(3);
    for (const Values& value : values) {
        rows_[0].push_back(value.red);
        rows_[1].push_back(value.green);
        rows_[2].push_back(value.blue);
    }
    if (rows_[0] == rows_[1] && rows_[0] == rows_[2]) rows_.resize(1);
}

void CurveTable::limitToCodes() {
    for (Row& row : rows_)
        for (float& value : row) value = std::clamp(value, 0.0f, 1.0f);
}

float CurveTable::at(int channel, float x) const {
    const Row& row = rows_[isShared() ? 0 : std::size_t(channel)];
    const std::int32_t bits = std::clamp(std::bit_cast<std::int32_t>(x + start) - startBits, 0, lastBits);
    const auto piece = std::size_t(bits >> pieceBits);
    return row[piece] + float(bits & ((1 << pieceBits) - 1)) * slope(row, piece);
}

int CurveTable::appendTo(std::vector<float>& texels) const {
    const int first = int(texels.size() / 2);
    for (const Row& row : rows_)
        for (std::size_t i = 0; i + 1 < row.size(); ++i)
            texels.insert(texels.end(), {row[i], slope(row, i)});
    return first;
}

int CurveTable::rowLength() {
    return pieces;
}

std::string CurveTable::glsl() {
    // Bits of negative numbers are negative integers and those of NaN beyond all others, so that the limits
    // serve for these too.
    return "uniform samplerBuffer candelaCurves;\n"
           "float candelaCurve(int firstTexel, float x) {\n"
           "    int bits = clamp(floatBitsToInt(x + intBitsToFloat(" + std::to_string(startBits) + ")) - " + std::to_string(startBits) + ", 0, " +
           std::to_string(lastBits) +
           ");\n"
           "    vec2 piece = texelFetch(candelaCurves, firstTexel + (bits >> " +
           std::to_string(pieceBits) +
           ")).rg;\n"
           "    return piece.x + float(bits & " +
           std::to_string((1 << pieceBits) - 1) +
           ") * piece.y;\n"
           "}\n";
}

}  // namespace candela
