#include "document_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace candela_plugins::gltf {
namespace {

using Json = nlohmann::json;

/// The bytes of the well-formed UTF-8 sequence that `text` begins with; 0 where there is none. Overlong forms
/// are left to the parser.
std::size_t sequenceLength(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xC2 ? 0
                               : first < 0xE0 ? 2
                               : first < 0xF0 ? 3
                               : first < 0xF5 ? 4
                                              : 0;
    if (length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((static_cast<unsigned char>(text[i]) & 0xC0u) != 0x80u) return 0;
    }
    return length;
}

/// The length of a number that JSON does not have at the start of `text`; 0 for anything else.
std::size_t notANumberLength(std::string_view text) {
    constexpr std::string_view words[] = {"NaN",  "nan",       "Infinity", "-NaN",
                                          "-nan", "-Infinity", "inf",      "-inf"};
    for (const std::string_view word : words) {
        if (text.starts_with(word)) return word.size();
    }
    return 0;
}

/// NaN and infinities become null, which is no number, and bytes outside of UTF-8 become '?'.
std::string repairedText(std::string_view text) {
    std::string repaired;
    repaired.reserve(text.size());
    bool inString = false;
    while (!text.empty()) {
        std::size_t length = std::max<std::size_t>(sequenceLength(text), 1);
        if (sequenceLength(text) == 0) {
            repaired += '?';
        } else if (const std::size_t number = inString ? 0 : notANumberLength(text); number > 0) {
            repaired += "null";
            length = number;
        } else {
            if (inString && text[0] == '\\' && text.size() > 1) length = 2;
            if (text[0] == '"') inString = !inString;
            repaired += text.substr(0, length);
        }
        text.remove_prefix(length);
    }
    return repaired;
}

/// Some exporters pad the text with zeros.
std::string_view withoutZeros(const Bytes& bytes) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data), bytes.size);
    while (text.ends_with('\0')) text.remove_suffix(1);
    return text;
}

[[noreturn]] void failParsing(const Json::exception& error) {
    // The library's messages begin with "[json.exception.parse_error.101] ".
    const std::string message = error.what();
    const std::size_t end = message.find("] ");
    throw Failure{"JSON", end == std::string::npos ? message : message.substr(end + 2)};
}

Json parse(std::string_view text, const Host& host) {
    try {
        return Json::parse(text);
    } catch (const Json::exception& error) {
        Json repaired = Json::parse(repairedText(text), nullptr, false);
        if (repaired.is_discarded()) failParsing(error);
        host.note(CANDELA_NOTE_REPAIRED, "JSON",
                  "NaN, infinities or text that is not UTF-8, which JSON does not have");
        return repaired;
    }
}

struct Version {
    int major = 0, minor = 0;
};

/// "2.0": two numbers and a dot (glTF 2.0, 3.2 and the schema of asset.version).
std::optional<Version> parseVersion(const std::string& text) {
    Version version;
    const char* end = text.data() + text.size();
    const auto major = std::from_chars(text.data(), end, version.major);
    if (major.ec != std::errc() || major.ptr == end || *major.ptr != '.') return std::nullopt;
    const auto minor = std::from_chars(major.ptr + 1, end, version.minor);
    if (minor.ec != std::errc() || minor.ptr != end) return std::nullopt;
    return version;
}

std::string versionName(const Version& version) {
    return std::to_string(version.major) + "." + std::to_string(version.minor);
}

/// A version written as a number, 2 or 2.0, is meant as text.
Version readVersion(const Json& value, const char* member, const Host& host) {
    std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    if (value.is_number()) {
        host.note(CANDELA_NOTE_REPAIRED, "asset", std::string(member) + " is a number, expected text");
        if (text.find('.') == std::string::npos) text += ".0";
    }
    const std::optional<Version> version = parseVersion(text);
    if (version) return *version;
    throw Failure{"asset", std::string(member) + " '" + readable(text) + "' is not of the form 2.0"};
}

bool isOfType(const Json& document, const char* member, Json::value_t type) {
    const auto found = document.find(member);
    return found != document.end() && found->type() == type;
}

/// glTF 1.0 has objects where glTF 2.0 has arrays.
bool looksLike(const Json& document, Json::value_t elements) {
    constexpr const char* members[] = {"accessors", "materials", "meshes", "nodes", "scenes"};
    return std::any_of(std::begin(members), std::end(members),
                       [&](const char* member) { return isOfType(document, member, elements); });
}

void requireVersion(const Json& asset, const Host& host) {
    const Version version = readVersion(asset["version"], "version", host);
    if (version.major != 2) {
        throw Failure{"asset", "glTF " + versionName(version) + " is not supported, expected glTF 2.0"};
    }
    if (!asset.contains("minVersion")) return;
    const Version minVersion = readVersion(asset["minVersion"], "minVersion", host);
    if (minVersion.major == 2 && minVersion.minor == 0) return;
    throw Failure{"asset", "minVersion " + versionName(minVersion) + " is not supported, expected 2.0"};
}

void checkVersion(Json& document, const Host& host) {
    const bool hasAsset = isOfType(document, "asset", Json::value_t::object);
    if (hasAsset && document["asset"].contains("version")) {
        requireVersion(document["asset"], host);
    } else if (looksLike(document, Json::value_t::object)) {
        throw Failure{"asset", "glTF 1.0 is not supported, expected glTF 2.0"};
    } else if (looksLike(document, Json::value_t::array)) {
        host.note(CANDELA_NOTE_REPAIRED, "asset", "without a version, read as glTF 2.0");
    } else {
        throw Failure{"asset", hasAsset ? "\"version\" is missing" : "is missing"};
    }
    document["asset"] = {{"version", "2.0"}};
}

}  // namespace

Json parseDocument(const Bytes& bytes, const Host& host) {
    const std::string_view text = withoutZeros(bytes);
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        throw Failure{"JSON", "the text is UTF-16, expected UTF-8"};
    }
    Json document = parse(text, host);
    if (!document.is_object()) throw Failure{"JSON", "the text is not an object"};
    checkVersion(document, host);
    return document;
}

}  // namespace candela_plugins::gltf
