#include "compressed_views.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace candela_plugins::gltf {
namespace {

using Mode = CompressedData::Mode;
using Filter = CompressedData::Filter;

struct Rule {
    bool holds;
    const char* expected;
};

/// The rules of KHR_meshopt_compression, "JSON schema updates".
void checkLayout(const CompressedData& data, std::uint64_t byteLength) {
    const std::uint64_t stride = data.byteStride;
    const bool isAttributes = data.mode == Mode::attributes;
    const bool isShort = stride == 4 || stride == 8;
    const Rule rules[] = {
        {byteLength == stride * data.count, "a byteLength of byteStride times count"},
        {!isAttributes || (stride % 4 == 0 && stride >= 4 && stride <= 256),
         "ATTRIBUTES with a byteStride that is a multiple of 4 up to 256"},
        {isAttributes || stride == 2 || stride == 4, "indices with a byteStride of 2 or 4"},
        {data.mode != Mode::triangles || data.count % 3 == 0, "TRIANGLES with a count of whole triangles"},
        {isAttributes || data.filter == Filter::none, "indices without a filter"},
        {data.filter != Filter::octahedral || isShort, "OCTAHEDRAL with a byteStride of 4 or 8"},
        {data.filter != Filter::quaternion || stride == 8, "QUATERNION with a byteStride of 8"},
        {data.filter != Filter::color || isShort, "COLOR with a byteStride of 4 or 8"},
    };
    for (const Rule& rule : rules) {
        if (!rule.holds) throw Failure{"", std::string("expected ") + rule.expected};
    }
}

/// The codecs spend at least a byte on a triangle or an index, and a quarter of a byte for each byte of 16
/// elements: larger claims are refused before they are allocated.
void checkSize(const CompressedData& data) {
    constexpr std::uint64_t maxRatio = 64;
    if (data.byteStride * data.count <= data.byteLength * maxRatio) return;
    throw Failure{"", std::to_string(data.byteLength) + " compressed bytes cannot hold " +
                          std::to_string(data.count) + " elements of " + std::to_string(data.byteStride) +
                          " bytes"};
}

/// The filter COLOR of KHR_meshopt_compression, which meshoptimizer has since version 0.25: luma and two
/// chroma differences of K bits to RGBA over all bits of `Component`. The highest bit of alpha tells K.
template <typename Component, typename SignedComponent>
void decodeColors(std::vector<std::uint8_t>& bytes) {
    constexpr auto max = static_cast<float>(std::numeric_limits<Component>::max());
    constexpr std::size_t stride = 4 * sizeof(Component);
    for (std::size_t at = 0; at + stride <= bytes.size(); at += stride) {
        Component color[4];
        std::memcpy(color, &bytes[at], stride);
        const int luma = color[0], orange = static_cast<SignedComponent>(color[1]),
                  green = static_cast<SignedComponent>(color[2]);
        const int full = (1 << std::bit_width(color[3])) - 1;
        const int alpha = color[3] & full >> 1;
        const float scale = full > 0 ? max / static_cast<float>(full) : 0.0f;
        const int rgba[4] = {luma + orange - green, luma + green, luma - orange - green,
                             alpha << 1 | (alpha & 1)};
        for (int i = 0; i < 4; ++i)
            color[i] = static_cast<Component>(
                std::clamp(std::round(static_cast<float>(rgba[i]) * scale), 0.0f, max));
        std::memcpy(&bytes[at], color, stride);
    }
}

void applyFilter(const CompressedData& data, std::vector<std::uint8_t>& bytes) {
    switch (data.filter) {
        case Filter::none:
            return;
        case Filter::octahedral:
            meshopt_decodeFilterOct(bytes.data(), data.count, data.byteStride);
            return;
        case Filter::quaternion:
            meshopt_decodeFilterQuat(bytes.data(), data.count, data.byteStride);
            return;
        case Filter::exponential:
            meshopt_decodeFilterExp(bytes.data(), data.count, data.byteStride);
            return;
        case Filter::color:
            if (data.byteStride == 4) {
                decodeColors<std::uint8_t, std::int8_t>(bytes);
            } else {
                decodeColors<std::uint16_t, std::int16_t>(bytes);
            }
            return;
    }
}

int decodeStream(const CompressedData& data, const Bytes& source, std::vector<std::uint8_t>& bytes) {
    switch (data.mode) {
        case Mode::triangles:
            return meshopt_decodeIndexBuffer(bytes.data(), data.count, data.byteStride, source.data,
                                             source.size);
        case Mode::indices:
            return meshopt_decodeIndexSequence(bytes.data(), data.count, data.byteStride, source.data,
                                               source.size);
        default:
            return meshopt_decodeVertexBuffer(bytes.data(), data.count, data.byteStride, source.data,
                                              source.size);
    }
}

/// The first byte of a stream of attributes names its format; meshoptimizer before 0.23 knows version 0.
bool isNewerFormat(const CompressedData& data, const Bytes& source) {
    constexpr std::uint8_t attributesVersion1 = 0xA1;
    return data.mode == Mode::attributes && source.size > 0 && source.data[0] == attributesVersion1;
}

std::vector<std::uint8_t> decode(const Document& document, const BufferView& view,
                                 const std::string& element) {
    const CompressedData& data = *view.compressed;
    try {
        checkLayout(data, view.byteLength);
        checkSize(data);
    } catch (const Failure& failure) {
        throw Failure{element + ", " + data.extension, failure.reason};
    }
    const Bytes source =
        bufferBytes(document, data.buffer, data.byteOffset, data.byteLength, "the compressed data", element);
    std::vector<std::uint8_t> bytes(data.byteStride * data.count);
    if (decodeStream(data, source, bytes) != 0) {
        throw Failure{element + ", " + data.extension,
                      isNewerFormat(data, source)
                          ? "attributes of format 1, which this build of meshoptimizer does not read"
                          : "the compressed data is damaged"};
    }
    applyFilter(data, bytes);
    return bytes;
}

/// A view whose bytes are in the file without compression, too.
bool hasPlainBytes(const Document& document, const BufferView& view, const std::string& element) {
    try {
        bufferBytes(document, view.buffer, view.byteOffset, view.byteLength, element, element);
        return true;
    } catch (const Failure&) {
        return false;
    }
}

}  // namespace

void decodeViews(Document& document, Storage& storage, const Host& host) {
    std::vector<std::size_t> compressed;
    for (std::size_t i = 0; i < document.bufferViews.size(); ++i) {
        if (document.bufferViews[i].compressed) compressed.push_back(i);
    }
    const std::size_t first = storage.size();
    storage.resize(first + compressed.size());
    std::vector<std::optional<Failure>> failures(compressed.size());
    const auto elementOf = [&](std::size_t i) {
        return elementName("bufferView", compressed[i], document.bufferViews[compressed[i]].name);
    };
    host.parallelFor(compressed.size(), [&](std::size_t i) {
        try {
            storage[first + i] = decode(document, document.bufferViews[compressed[i]], elementOf(i));
        } catch (const Failure& failure) {
            failures[i] = failure;
        }
    });
    for (std::size_t i = 0; i < compressed.size(); ++i) {
        BufferView& view = document.bufferViews[compressed[i]];
        const std::string element = elementOf(i);
        if (!failures[i]) {
            view.decoded = Bytes{storage[first + i].data(), storage[first + i].size()};
        } else if (hasPlainBytes(document, view, element)) {
            host.note(CANDELA_NOTE_REPAIRED, failures[i]->element,
                      failures[i]->reason + ": the uncompressed data is read");
        } else {
            document.faults.emplace(element, *failures[i]);
        }
    }
}

}  // namespace candela_plugins::gltf
