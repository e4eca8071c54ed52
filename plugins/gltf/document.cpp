#include "document.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

#include "schema.h"

namespace candela_plugins::gltf {
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
    const Version minVersion = readVersion(*asset, "minVersion");
    if (minVersion.major != 2 || minVersion.minor > 0) {
        throw Failure{"asset", "minVersion " + std::to_string(minVersion.major) + "." +
                                   std::to_string(minVersion.minor) + " is not supported, expected 2.0"};
    }
}

void checkExtensions(const Json& document, const Host& host) {
    for (const std::string& name : extensionList(document, "extensionsRequired")) {
        if (isKnown(name)) continue;
        throw Failure{"extensionsRequired", "extension '" + readable(name) + "' is not supported"};
    }
    for (const std::string& name : extensionList(document, "extensionsUsed")) {
        if (!isKnown(name))
            host.note(CANDELA_NOTE_MISSING, "extension '" + readable(name) + "'", "not supported: ignored");
    }
}

bool usesExtension(const Json& document, const char* name) {
    for (const char* member : {"extensionsUsed", "extensionsRequired"}) {
        const std::vector<std::string> names = extensionList(document, member);
        if (std::find(names.begin(), names.end(), name) != names.end()) return true;
    }
    return false;
}

using Json = nlohmann::json;

Json parseJson(const Bytes& text) {
    const char* begin = reinterpret_cast<const char*>(text.data);
    try {
        Json document = Json::parse(begin, begin + text.size);
        if (!document.is_object()) throw Failure{"JSON", "the text is not an object"};
        return document;
    } catch (const Json::exception& error) {
        // The library's messages begin with "[json.exception.parse_error.101] ".
        const std::string message = error.what();
        const std::size_t end = message.find("] ");
        throw Failure{"JSON", end == std::string::npos ? message : message.substr(end + 2)};
    }
}

/// The elements of an array member that are objects; what is not well-formed is left to the schema.
template <typename Use>
void forEachObject(Json& parent, const char* member, const Use& use) {
    const auto found = parent.find(member);
    if (found == parent.end() || !found->is_array()) return;
    for (Json& element : *found) {
        if (element.is_object()) use(element);
    }
}

std::string counted(std::size_t count, const char* noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// Skins and morph targets deform cages only.
void noteDeformations(const Document& document, const Host& host) {
    std::size_t skinned = 0, morphed = 0;
    for (const tinygltf::Node& node : document.model.nodes) {
        const bool showsCage = node.mesh >= 0 && document.cages.contains(static_cast<std::size_t>(node.mesh));
        skinned += node.skin >= 0 && !showsCage;
    }
    for (std::size_t i = 0; i < document.model.meshes.size(); ++i) {
        const auto& primitives = document.model.meshes[i].primitives;
        const bool hasTargets =
            std::any_of(primitives.begin(), primitives.end(),
                        [](const tinygltf::Primitive& primitive) { return !primitive.targets.empty(); });
        morphed += hasTargets && !document.cages.contains(i);
    }
    if (skinned > 0) {
        host.note(CANDELA_NOTE_MISSING, "",
                  "skins are not applied: " + counted(skinned, "node") + " drawn in the bind pose");
    }
    if (morphed > 0) {
        host.note(CANDELA_NOTE_MISSING, "",
                  "morph targets are not applied: " + counted(morphed, "mesh") + " drawn in the bind pose");
    }
}

/// glTF allows channels without a node, which the specification says to ignore; tinygltf refuses them.
void removeChannelsWithoutNode(Json& document) {
    forEachObject(document, "animations", [](Json& animation) {
        const auto channels = animation.find("channels");
        if (channels == animation.end() || !channels->is_array()) return;
        for (auto channel = channels->begin(); channel != channels->end();) {
            const bool hasTarget = channel->is_object() && channel->contains("target");
            const bool noNode =
                hasTarget && (*channel)["target"].is_object() && !(*channel)["target"].contains("node");
            channel = noNode ? channels->erase(channel) : std::next(channel);
        }
    });
}

/// tinygltf silently prefers the matrix.
void refuseAmbiguousTransforms(Json& document) {
    std::size_t index = 0;
    forEachObject(document, "nodes", [&](Json& node) {
        const bool parts =
            node.contains("translation") || node.contains("rotation") || node.contains("scale");
        if (node.contains("matrix") && parts) {
            throw Failure{elementName("node", index, node.value("name", std::string())),
                          "has both a matrix and translation, rotation or scale"};
        }
        ++index;
    });
}

/// tinygltf refuses an index accessor without a bufferView, which glTF allows; it accepts one as an
/// attribute.
void moveIndices(Json& document) {
    forEachObject(document, "meshes", [](Json& mesh) {
        forEachObject(mesh, "primitives", [](Json& primitive) {
            const auto indices = primitive.find("indices");
            if (indices == primitive.end()) return;
            primitive["attributes"][indicesAttribute] = *indices;
            primitive.erase("indices");
        });
    });
}

std::vector<Source> takeSources(Json& document, const char* member) {
    std::vector<Source> sources;
    forEachObject(document, member, [&](Json& element) {
        Source source;
        source.name = element.value("name", std::string());
        source.byteLength = element.value("byteLength", std::uint64_t(0));
        if (element.contains("uri")) source.uri = std::move(element["uri"].get_ref<std::string&>());
        if (element.contains("bufferView")) source.bufferView = element["bufferView"].get<std::size_t>();
        sources.push_back(std::move(source));
    });
    document.erase(member);
    return sources;
}

std::vector<SkinSource> takeSkins(Json& document) {
    std::vector<SkinSource> skins;
    forEachObject(document, "skins", [&](Json& element) {
        SkinSource skin;
        skin.name = element.value("name", std::string());
        skin.joints = element["joints"].get<std::vector<std::size_t>>();
        if (element.contains("inverseBindMatrices")) {
            skin.inverseBindMatrices = element["inverseBindMatrices"].get<std::size_t>();
        }
        skins.push_back(std::move(skin));
    });
    document.erase("skins");
    return skins;
}

void loadModel(tinygltf::Model& model, const Json& document) {
    const std::string text = document.dump();
    if (text.size() > std::numeric_limits<unsigned int>::max()) throw Failure{"JSON", "is larger than 4 GiB"};
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks({});
    std::string errors, warnings;
    const bool loaded = loader.LoadASCIIFromString(&model, &errors, &warnings, text.data(),
                                                   static_cast<unsigned int>(text.size()), "");
    // After some errors tinygltf continues without the element.
    if (!loaded || !errors.empty()) throw Failure{"JSON", readable(errors)};
}

}  // namespace

Document readDocument(const Bytes& text, const Host& host) {
    Json json = parseJson(text);
    checkVersion(json);
    checkExtensions(json, host);

    Document document;
    document.quantized = usesExtension(json, "KHR_mesh_quantization");
    document.cages = readCageSettings(json);
    removeChannelsWithoutNode(json);
    conform(json, documentSchema());
    refuseAmbiguousTransforms(json);
    moveIndices(json);
    document.bufferSources = takeSources(json, "buffers");
    document.imageSources = takeSources(json, "images");
    document.skins = takeSkins(json);
    loadModel(document.model, json);
    noteDeformations(document, host);
    return document;
}

}  // namespace candela_plugins::gltf
