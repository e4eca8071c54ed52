#include "document.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "extensions.h"
#include "shapes.h"

namespace candela_gltf {
namespace {

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

/// Only cages move with skins and morph targets.
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
        host.note("skins are not applied: " + counted(skinned, "node") + " drawn in the bind pose");
    }
    if (morphed > 0) {
        host.note("morph targets are not applied: " + counted(morphed, "mesh") + " drawn in the bind pose");
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

/// tinygltf lets a matrix win silently.
void refuseTwofoldTransforms(Json& document) {
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

/// tinygltf refuses an index accessor that has no bufferView, which glTF allows; among the attributes it does
/// not mind.
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
    // tinygltf goes on after some errors and leaves elements out.
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
    conform(json, documentShape());
    refuseTwofoldTransforms(json);
    moveIndices(json);
    document.bufferSources = takeSources(json, "buffers");
    document.imageSources = takeSources(json, "images");
    document.skins = takeSkins(json);
    loadModel(document.model, json);
    noteDeformations(document, host);
    return document;
}

}  // namespace candela_gltf
