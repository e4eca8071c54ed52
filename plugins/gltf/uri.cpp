#include "uri.h"

#include <array>
#include <string_view>

namespace candela_gltf {
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

}  // namespace candela_gltf
