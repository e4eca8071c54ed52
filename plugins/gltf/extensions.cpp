#include "extensions.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace candela_gltf {
namespace {

using Json = nlohmann::json;

constexpr std::string_view knownExtensions[] = {
    "FB_ngon_encoding",    "KHR_lights_punctual",   "KHR_materials_emissive_strength",
    "KHR_materials_unlit", "KHR_mesh_quantization", "KHR_texture_transform",
};

bool isKnown(const std::string& extension) {
    return std::find(std::begin(knownExtensions), std::end(knownExtensions), extension) !=
           std::end(knownExtensions);
}

std::vector<std::string> extensionList(const Json& document, const char* member) {
    std::vector<std::string> names;
    const auto list = document.find(member);
    if (list == document.end()) return names;
    if (!list->is_array()) throw Failure{member, "expected an array of strings"};
    for (const Json& name : *list) {
        if (!name.is_string()) throw Failure{member, "expected an array of strings"};
        names.push_back(name.get<std::string>());
    }
    return names;
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

Version readVersion(const Json& asset, const char* member) {
    const Json& value = asset[member];
    if (!value.is_string()) throw Failure{"asset", std::string("\"") + member + "\" is not a string"};
    const std::string text = value.get<std::string>();
    const std::optional<Version> version = parseVersion(text);
    if (!version) {
        throw Failure{"asset", std::string(member) + " '" + readable(text) + "' is not of the form 2.0"};
    }
    return *version;
}

}  // namespace

void checkVersion(const Json& document) {
    const auto asset = document.find("asset");
    if (asset == document.end() || !asset->is_object()) throw Failure{"asset", "is missing"};
    if (!asset->contains("version")) throw Failure{"asset", "\"version\" is missing"};
    const Version version = readVersion(*asset, "version");
    if (version.major != 2) {
        throw Failure{"asset", "version " + std::to_string(version.major) + "." +
                                   std::to_string(version.minor) + " is not supported, expected 2.0"};
    }
    if (!asset->contains("minVersion")) return;
    const Version least = readVersion(*asset, "minVersion");
    if (least.major != 2 || least.minor > 0) {
        throw Failure{"asset", "minVersion " + std::to_string(least.major) + "." +
                                   std::to_string(least.minor) + " is not supported, expected 2.0"};
    }
}

void checkExtensions(const Json& document, const Host& host) {
    for (const std::string& name : extensionList(document, "extensionsRequired")) {
        if (isKnown(name)) continue;
        throw Failure{"extensionsRequired", "extension '" + readable(name) + "' is not supported"};
    }
    for (const std::string& name : extensionList(document, "extensionsUsed")) {
        if (!isKnown(name)) host.note("extension '" + readable(name) + "' is not supported: ignored");
    }
}

bool usesExtension(const Json& document, const char* name) {
    for (const char* member : {"extensionsUsed", "extensionsRequired"}) {
        const std::vector<std::string> names = extensionList(document, member);
        if (std::find(names.begin(), names.end(), name) != names.end()) return true;
    }
    return false;
}

}  // namespace candela_gltf
