#include "color/curve_table.h"

#include "color/curve_segments.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace candela {

namespace {

float numberAt(int segment) {
    return std::bit_cast<float>(curveStartBits + (segment << curveSegmentBits)) - curveStart;
}

float slope(const std::vector<float>& row, std::size_t segment) {
    return (row[segment + 1] - row[segment]) * (1.0f / float(1 << curveSegmentBits));
}

}  // namespace

CurveTable::CurveTable(const Function& function) {
    std::vector<Values> values;
    for (int i = 0; i <= curveSegments; ++i) values.push_back({numberAt(i), numberAt(i), numberAt(i)});
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
    const std::int32_t bits = std::clamp(std::bit_cast<std::int32_t>(x + curveStart), curveStartBits, curveLastBits);
    const auto segment = std::size_t((bits - curveStartBits) >> curveSegmentBits);
    return row[segment] + float(bits & curveSegmentMask) * slope(row, segment);
}

int CurveTable::appendTo(std::vector<float>& texels) const {
    const int first = int(texels.size() / 2);
    for (const Row& row : rows_)
        for (std::size_t i = 0; i + 1 < row.size(); ++i) texels.insert(texels.end(), {row[i], slope(row, i)});
    return first;
}

int CurveTable::rowLength() {
    return curveSegments;
}

std::string CurveTable::glsl() {
    const std::string first = std::to_string(curveStartBits), last = std::to_string(curveLastBits);
    // As integers, the bits of negative numbers are negative and those of NaN lie beyond all others, so that
    // the clamp covers both.
    return "uniform samplerBuffer candelaCurves;\n"
           "float candelaCurve(int firstTexel, float x) {\n"
           "    int bits = clamp(floatBitsToInt(x + intBitsToFloat(" +
           first + ")), " + first + ", " + last +
           ");\n"
           "    vec2 segment = texelFetch(candelaCurves, firstTexel + (bits >> " +
           std::to_string(curveSegmentBits) + ") - " + std::to_string(curveStartBits >> curveSegmentBits) +
           ").rg;\n"
           "    return segment.x + float(bits & " +
           std::to_string(curveSegmentMask) +
           ") * segment.y;\n"
           "}\n";
}

}  // namespace candela
