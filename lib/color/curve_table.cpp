#include "color/curve_table.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace candela {

namespace {

// 128 segments per octave approximate a power function to a relative error of 1e-5; display curves are
// locally powers. That is more than 8 bits need, but a view's matrix subtracts channels from each other, and
// near black the display's curve amplifies the remaining error. On llvmpipe 32 segments per octave are no
// faster. `start` is added to a number before its bits are taken, so that the segments below it have a
// constant length down to zero: 2^-31, over which the steepest of the displays' curves, gamma 2.6, rises by a
// fifteenth of a code.
constexpr float start = 1.0f / 16777216.0f;
constexpr int segmentBits = 16;
constexpr std::int32_t startBits = std::bit_cast<std::int32_t>(start);  // a multiple of a segment
constexpr std::int32_t endBits = std::bit_cast<std::int32_t>(CurveTable::end);
constexpr int segments = (endBits - startBits) >> segmentBits;
constexpr std::int32_t lastBits = startBits + (segments << segmentBits) - 1;
constexpr std::int32_t segmentMask = (1 << segmentBits) - 1;

float numberAt(int segment) {
    return std::bit_cast<float>(startBits + (segment << segmentBits)) - start;
}

float slope(const std::vector<float>& row, std::size_t segment) {
    return (row[segment + 1] - row[segment]) * (1.0f / float(1 << segmentBits));
}

}  // namespace

CurveTable::CurveTable(const Function& function) {
    std::vector<Values> values;
    for (int i = 0; i <= segments; ++i) values.push_back({numberAt(i), numberAt(i), numberAt(i)});
    function(values);
    rows_.resize(3);
    for (const Values& value : values) {
        rows_[0].push_back(value.red);
        rows_[1].push_back(value.green);
        rows_[2].push_back(value.blue);
    }
    if (rows_[0] == rows_[1] && rows_[0] == rows_[2]) rows_.resize(1);
}

void CurveTable::clampToCodes() {
    for (Row& row : rows_)
        for (float& value : row) value = std::clamp(value, 0.0f, 1.0f);
}

float CurveTable::at(int channel, float x) const {
    const Row& row = rows_[isShared() ? 0 : std::size_t(channel)];
    const std::int32_t bits = std::clamp(std::bit_cast<std::int32_t>(x + start), startBits, lastBits);
    const auto segment = std::size_t((bits - startBits) >> segmentBits);
    return row[segment] + float(bits & segmentMask) * slope(row, segment);
}

int CurveTable::appendTo(std::vector<float>& texels) const {
    const int first = int(texels.size() / 2);
    for (const Row& row : rows_)
        for (std::size_t i = 0; i + 1 < row.size(); ++i) texels.insert(texels.end(), {row[i], slope(row, i)});
    return first;
}

int CurveTable::rowLength() {
    return segments;
}

std::string CurveTable::glsl() {
    const std::string first = std::to_string(startBits), last = std::to_string(lastBits);
    // As integers, the bits of negative numbers are negative and those of NaN lie beyond all others, so that
    // the clamp covers both.
    return "uniform samplerBuffer candelaCurves;\n"
           "float candelaCurve(int firstTexel, float x) {\n"
           "    int bits = clamp(floatBitsToInt(x + intBitsToFloat(" +
           first + ")), " + first + ", " + last +
           ");\n"
           "    vec2 segment = texelFetch(candelaCurves, firstTexel + (bits >> " +
           std::to_string(segmentBits) + ") - " + std::to_string(startBits >> segmentBits) +
           ").rg;\n"
           "    return segment.x + float(bits & " +
           std::to_string(segmentMask) +
           ") * segment.y;\n"
           "}\n";
}

}  // namespace candela
