#include "buffers.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace candela_plugins::gltf {
namespace {

constexpr std::uint64_t headerSize = 12, chunkHeaderSize = 8;
constexpr std::uint32_t jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;

std::uint32_t littleEndian32(const std::uint8_t* p) {
    return p[0] | std::uint32_t(p[1]) << 8 | std::uint32_t(p[2]) << 16 | std::uint32_t(p[3]) << 24;
}

[[noreturn]] void failBinary(const std::string& reason) {
    throw Failure{"binary glTF", reason};
}

struct Chunk {
    std::uint32_t type = 0;
    Bytes content;
};

Chunk readChunk(const Bytes& file, std::uint64_t offset, int number, const Host& host) {
    const std::string which = "chunk " + std::to_string(number);
    if (file.size - offset < chunkHeaderSize) failBinary(which + " is cut off within its header");
    const std::uint64_t length = littleEndian32(file.data + offset);
    const std::uint64_t available = file.size - offset - chunkHeaderSize;
    const Chunk chunk{littleEndian32(file.data + offset + 4),
                      {file.data + offset + chunkHeaderSize, std::min(length, available)}};
    if (length > available) {
        const std::string reason = which + " has a length of " + std::to_string(length) +
                                   " bytes, but only " + std::to_string(available) + " are left";
        if (chunk.type == jsonChunk) failBinary(reason);
        host.note(CANDELA_NOTE_MISSING, "binary glTF", reason);
    }
    if (length % 4 != 0) {
        host.note(CANDELA_NOTE_REPAIRED, "binary glTF",
                  which + " has a length that is not a multiple of 4: read as it is");
    }
    return chunk;
}

/// The second chunk, where it is of type BIN; what follows it belongs to extensions. It begins where the
/// first one ends, or, where that is not a multiple of 4, at the next one.
std::optional<Bytes> readBinaryChunk(const Bytes& file, std::uint64_t end, const Host& host) {
    const std::uint64_t aligned = (end + 3) / 4 * 4;
    for (const std::uint64_t offset : {end, aligned}) {
        if (offset > file.size || file.size - offset < chunkHeaderSize) return std::nullopt;
        if (littleEndian32(file.data + offset + 4) != binaryChunk) continue;
        return readChunk(file, offset, 1, host).content;
    }
    return std::nullopt;
}

Container openBinary(const Bytes& file, const Host& host) {
    if (file.size < headerSize) failBinary("the file is cut off within its header");
    const std::uint32_t version = littleEndian32(file.data + 4);
    if (version == 1) failBinary("glTF 1.0 (container version 1) is not supported, expected glTF 2.0");
    if (version != 2) failBinary("container version " + std::to_string(version) + ", expected 2");
    const std::uint64_t length = littleEndian32(file.data + 8);
    if (length != file.size) {
        host.note(CANDELA_NOTE_REPAIRED, "binary glTF",
                  "the header says " + std::to_string(length) + " bytes, but the file has " +
                      std::to_string(file.size));
    }
    const Chunk first = readChunk(file, headerSize, 0, host);
    if (first.type != jsonChunk) failBinary("chunk 0 is not of type JSON");
    const std::uint64_t end = headerSize + chunkHeaderSize + first.content.size;
    return {first.content, readBinaryChunk(file, end, host)};
}

}  // namespace

Container openContainer(const Bytes& file, const Host& host) {
    const bool binary = file.size >= 4 && std::memcmp(file.data, "glTF", 4) == 0;
    return binary ? openBinary(file, host) : Container{file, std::nullopt};
}

namespace {

constexpr std::uint8_t notADigit = 0xFF;

std::uint8_t hexDigit(char c) {
    if (c >= '0' && c <= '9') return static_cast<std::uint8_t>(c - '0');
    if (c >= 'a' && c <= 'f') return static_cast<std::uint8_t>(c - 'a' + 10);
    if (c >= 'A' && c <= 'F') return static_cast<std::uint8_t>(c - 'A' + 10);
    return notADigit;
}

std::string percentDecode(std::string_view text, const std::string& element) {
    std::string out;
    out.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            out += text[i];
            continue;
        }
        const std::uint8_t high = i + 2 < text.size() ? hexDigit(text[i + 1]) : notADigit;
        const std::uint8_t low = i + 2 < text.size() ? hexDigit(text[i + 2]) : notADigit;
        if (high == notADigit || low == notADigit) {
            throw Failure{element, "URI: '%' at character " + std::to_string(i) +
                                       " is not followed by two hexadecimal digits"};
        }
        out += static_cast<char>(high << 4 | low);
        i += 2;
    }
    return out;
}

std::array<std::uint8_t, 256> makeBase64Values() {
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<std::uint8_t, 256> values{};
    values.fill(notADigit);
    for (std::size_t i = 0; i < alphabet.size(); ++i) {
        values[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
    }
    return values;
}

std::vector<std::uint8_t> base64Decode(std::string_view text, const std::string& element) {
    static const std::array<std::uint8_t, 256> values = makeBase64Values();
    std::size_t padding = 0;
    while (padding < 2 && !text.empty() && text.back() == '=') {
        text.remove_suffix(1);
        ++padding;
    }
    const bool rightLength = padding == 0 ? text.size() % 4 != 1 : (text.size() + padding) % 4 == 0;
    if (!rightLength) throw Failure{element, "data URI: the base64 text is cut off"};

    std::vector<std::uint8_t> out;
    out.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int bitCount = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::uint8_t value = values[static_cast<unsigned char>(text[i])];
        if (value == notADigit) {
            throw Failure{element, "data URI: character " + std::to_string(i) +
                                       " of the base64 text does not belong to base64"};
        }
        bits = bits << 6 | value;
        bitCount += 6;
        if (bitCount < 8) continue;
        bitCount -= 8;
        out.push_back(static_cast<std::uint8_t>(bits >> bitCount));
    }
    return out;
}

/// "http" for "http://host/a.png"; empty for a relative reference (RFC 3986, 3.1 and 4.2).
std::string_view schemeOf(std::string_view uri) {
    const std::size_t end = uri.find_first_of(":/?#");
    return end == std::string_view::npos || uri[end] != ':' ? std::string_view() : uri.substr(0, end);
}

}  // namespace

bool isDataUri(const std::string& uri) {
    return uri.starts_with("data:");
}

std::vector<std::uint8_t> decodeDataUri(const std::string& uri, const std::string& element) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string::npos) throw Failure{element, "data URI: no ',' before the data"};
    const std::string_view header = std::string_view(uri).substr(0, comma);
    const std::string_view data = std::string_view(uri).substr(comma + 1);
    if (header.ends_with(";base64")) return base64Decode(data, element);
    const std::string decoded = percentDecode(data, element);
    return {decoded.begin(), decoded.end()};
}

std::string pathOfUri(const std::string& uri, const std::string& element) {
    if (uri.empty()) throw Failure{element, "the URI is empty"};
    const std::string_view scheme = schemeOf(uri);
    if (!scheme.empty()) {
        throw Failure{element, "URI scheme '" + readable(std::string(scheme)) +
                                   "' is not supported, expected a relative path or 'data'"};
    }
    std::string path = percentDecode(uri, element);
    if (path.find('\0') != std::string::npos) throw Failure{element, "the URI has a zero in it"};
    return path;
}

namespace {

Bytes findBytes(const Source& source, std::size_t index, const std::string& element,
                const Container& container, Storage& storage, const Host& host) {
    if (source.uri) return loadUri(*source.uri, element, storage, host);
    // Only the first buffer may stand for the BIN chunk (glTF 2.0, 4.4.3.3).
    if (index == 0 && container.binary) return *container.binary;
    throw Failure{element, index == 0 ? "has no URI, and the file has no BIN chunk" : "has no URI"};
}

}  // namespace

namespace {

/// What exporters mean by a URI that is not percent-encoded, or has the separators of Windows.
std::vector<std::string> otherPaths(const std::string& uri) {
    std::string slashes = uri;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    std::vector<std::string> paths;
    if (uri.find('%') != std::string::npos) paths.push_back(uri);
    if (slashes != uri) paths.push_back(slashes);
    return paths;
}

Bytes readFile(const std::string& uri, const std::string& element, const Host& host) {
    try {
        return host.readOptionalFile(pathOfUri(uri, element), element);
    } catch (const Failure& failure) {
        for (const std::string& path : otherPaths(uri)) {
            try {
                const Bytes bytes = host.readOptionalFile(path, element);
                host.note(CANDELA_NOTE_REPAIRED, element, "a path in place of a URI, read as it is");
                return bytes;
            } catch (const Failure&) {
                // The first reason is told.
            }
        }
        throw failure;
    }
}

}  // namespace

Bytes loadUri(const std::string& uri, const std::string& element, Storage& storage, const Host& host) {
    if (!isDataUri(uri)) return readFile(uri, element, host);
    const std::vector<std::uint8_t>& data = storage.emplace_back(decodeDataUri(uri, element));
    return {data.data(), data.size()};
}

namespace {

void noteLength(const Bytes& bytes, const Source& source, const std::string& element, const Host& host) {
    if (!source.byteLength || bytes.size >= *source.byteLength) return;
    host.note(CANDELA_NOTE_MISSING, element,
              "holds " + std::to_string(bytes.size) +
                  " bytes, expected byteLength = " + std::to_string(*source.byteLength));
}

}  // namespace

void loadBuffers(Document& document, const Container& container, Storage& storage, const Host& host) {
    for (std::size_t i = 0; i < document.bufferSources.size(); ++i) {
        Source& source = document.bufferSources[i];
        const std::string element = elementName("buffer", i, source.name);
        Bytes bytes;
        try {
            requireUsable(document, element);
            bytes = findBytes(source, i, element, container, storage, host);
            noteLength(bytes, source, element, host);
        } catch (const Failure& failure) {
            document.faults.emplace(element, failure);
        }
        document.buffers.push_back(bytes);
        source.uri.reset();
    }
}

Bytes bufferBytes(const Document& document, std::size_t buffer, std::uint64_t byteOffset,
                  std::uint64_t byteLength, const std::string& part, const std::string& element) {
    const std::string name = elementName("buffer", buffer, document.bufferSources.at(buffer).name);
    requireUsable(document, name, element);
    // What lies behind the buffer's byteLength is read where it is there.
    const Bytes& bytes = document.buffers.at(buffer);
    if (byteOffset > bytes.size || byteLength > bytes.size - byteOffset) {
        throw Failure{element, part + " ends at byte " + std::to_string(byteOffset + byteLength) + ", but " +
                                   name + " has " + std::to_string(bytes.size)};
    }
    return {bytes.data + byteOffset, byteLength};
}

Bytes viewBytes(const Document& document, std::size_t bufferView, const std::string& element) {
    const BufferView& view = document.bufferViews.at(bufferView);
    const std::string name = elementName("bufferView", bufferView, view.name);
    requireUsable(document, name, element);
    if (view.decoded) return *view.decoded;
    return bufferBytes(document, view.buffer, view.byteOffset, view.byteLength, name, element);
}

}  // namespace candela_plugins::gltf
