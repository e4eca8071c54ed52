#include "color/curve_table.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace candela {

namespace {

// 128 pieces an octave meet a power, of which display curves are made locally, to 1e-5 of its value. More
// than a code needs, but where a view's matrix takes channels from each other, what is left near black is
// steepened by the display's curve. On llvmpipe 32 pieces an octave are no faster.
// `start` is added to a number before its bits are taken, so that the pieces below it are of one length down
// to zero: 2^-31, over which the steepest of the displays' curves, gamma 2.6, rises by a fifteenth of a code.
constexpr float start = 1.0f / 16777216.0f;
constexpr int pieceBits = 16;
constexpr std::int32_t startBits = std::bit_cast<std::int32_t>(start);  // a multiple of a piece
constexpr std::int32_t endBits = std::bit_cast<std::int32_t>(CurveTable::end);
constexpr int pieces = (endBits - startBits) >> pieceBits;
constexpr std::int32_t lastBits = startBits + (pieces << pieceBits) - 1;
constexpr std::int32_t pieceMask = (1 << pieceBits) - 1;

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
    const std::int32_t bits = std::clamp(std::bit_cast<std::int32_t>(x + start), startBits, lastBits);
    const auto piece = std::size_t((bits - startBits) >> pieceBits);
    return row[piece] + float(bits & pieceMask) * slope(row, piece);
}

int CurveTable::appendTo(std::vector<float>& texels) const {
    const int first = int(texels.size() / 2);
    for (const Row& row : rows_)
        for (std::size_t i = 0; i + 1 < row.size(); ++i) texels.insert(texels.end(), {row[i], slope(row, i)});
    return first;
}

int CurveTable::rowLength() {
    return pieces;
}

std::string CurveTable::glsl() {
    const std::string first = std::to_string(startBits), last = std::to_string(lastBits);
    // As integers, the bits of negative numbers are negative and those of NaN lie beyond all others, so that
    // the limits serve for these too.
    return "uniform samplerBuffer candelaCurves;\n"
           "float candelaCurve(int firstTexel, float x) {\n"
           "    int bits = clamp(floatBitsToInt(x + intBitsToFloat(" +
           first + ")), " + first + ", " + last +
           ");\n"
           "    vec2 piece = texelFetch(candelaCurves, firstTexel + (bits >> " +
           std::to_string(pieceBits) + ") - " + std::to_string(startBits >> pieceBits) +
           ").rg;\n"
           "    return piece.x + float(bits & " +
           std::to_string(pieceMask) +
           ") * piece.y;\n"
           "}\n";
}

}  // namespace candela
