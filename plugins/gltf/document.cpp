#include "document.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <vector>

#include "document_text.h"
#include "extensions.h"

namespace candela_plugins::gltf {
namespace {

using Json = nlohmann::json;

/// The elements of an array member that are objects; what is not well-formed is left to the schema.
template <typename Use>
void forEachObject(Json& parent, const char* member, const Use& use) {
    const auto found = parent.find(member);
    if (found == parent.end() || !found->is_array()) return;
    for (Json& element : *found) {
        if (element.is_object()) use(element);
    }
}

/// glTF allows channels without a node, which extensions give a meaning; tinygltf refuses them.
void fillChannelNodes(Json& document) {
    forEachObject(document, "animations", [](Json& animation) {
        forEachObject(animation, "channels", [](Json& channel) {
            Json& target = channel["target"];
            if (target.contains("node")) return;
            // Notes of the importer are about paths that it does not know.
            if (target["path"] != "pointer") target["path"] = "";
            target["node"] = 0;
        });
    });
}

/// A camera has the object of its type, or it has a fault.
void refuseIncompleteCameras(Json& document, Faults& faults) {
    std::size_t index = 0;
    forEachObject(document, "cameras", [&](Json& camera) {
        const std::string element = elementName("camera", index++, camera.value("name", std::string()));
        const std::string type = camera["type"].get<std::string>();
        if (camera.contains(type)) return;
        faults.emplace(element, Failure{element, "\"" + type + "\" is missing"});
        camera["type"] = "orthographic";
        camera["orthographic"] = {{"xmag", 1.0}, {"ymag", 1.0}, {"zfar", 1.0}, {"znear", 0.0}};
    });
}

/// The values that tinygltf asks for where the importer has defaults of its own.
void fillDefaults(Json& document, const Host& host) {
    forEachObject(document, "cameras", [](Json& camera) {
        if (camera.contains("perspective")) camera["perspective"].emplace("znear", 0.0);
    });
    const Json::json_pointer lights("/extensions/KHR_lights_punctual");
    if (!document.contains(lights)) return;
    std::size_t index = 0;
    forEachObject(document[lights], "lights", [&](Json& light) {
        const std::string element = elementName("light", index++, light.value("name", std::string()));
        if (light["type"] != "spot" || light.contains("spot")) return;
        host.note(CANDELA_NOTE_REPAIRED, element, "a spot light without \"spot\": the default cone is used");
        light["spot"] = Json::object();
    });
}

/// tinygltf silently prefers the matrix.
void removeAmbiguousTransforms(Json& document, const Host& host) {
    std::size_t index = 0;
    forEachObject(document, "nodes", [&](Json& node) {
        const std::size_t i = index++;
        const bool parts =
            node.contains("translation") || node.contains("rotation") || node.contains("scale");
        if (!node.contains("matrix") || !parts) return;
        host.note(CANDELA_NOTE_REPAIRED, elementName("node", i, node.value("name", std::string())),
                  "both a matrix and translation, rotation or scale: the matrix is used");
        for (const char* part : {"translation", "rotation", "scale"}) node.erase(part);
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
        if (element.contains("byteLength")) source.byteLength = element["byteLength"].get<std::uint64_t>();
        if (element.contains("uri")) source.uri = std::move(element["uri"].get_ref<std::string&>());
        if (element.contains("bufferView")) source.bufferView = element["bufferView"].get<std::size_t>();
        sources.push_back(std::move(source));
    });
    document.erase(member);
    return sources;
}

template <typename Value, std::size_t count>
Value namedValue(const Json& object, const char* member,
                 const std::pair<const char*, Value> (&values)[count]) {
    const std::string name = object.value(member, std::string(values[0].first));
    for (const auto& [valueName, value] : values) {
        if (name == valueName) return value;
    }
    return values[0].second;
}

std::optional<CompressedData> compressedDataOf(const Json& view) {
    using Mode = CompressedData::Mode;
    using Filter = CompressedData::Filter;
    constexpr std::pair<const char*, Mode> modes[] = {
        {"ATTRIBUTES", Mode::attributes}, {"TRIANGLES", Mode::triangles}, {"INDICES", Mode::indices}};
    constexpr std::pair<const char*, Filter> filters[] = {{"NONE", Filter::none},
                                                          {"OCTAHEDRAL", Filter::octahedral},
                                                          {"QUATERNION", Filter::quaternion},
                                                          {"EXPONENTIAL", Filter::exponential},
                                                          {"COLOR", Filter::color}};
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        const Json::json_pointer place(std::string("/extensions/") + name);
        if (!view.contains(place)) continue;
        const Json& extension = view[place];
        return CompressedData{name,
                              extension["buffer"].get<std::size_t>(),
                              extension.value("byteOffset", std::uint64_t(0)),
                              extension["byteLength"].get<std::uint64_t>(),
                              extension["byteStride"].get<std::uint64_t>(),
                              extension["count"].get<std::uint64_t>(),
                              namedValue(extension, "mode", modes),
                              namedValue(extension, "filter", filters)};
    }
    return std::nullopt;
}

std::vector<BufferView> takeBufferViews(Json& document) {
    std::vector<BufferView> views;
    forEachObject(document, "bufferViews", [&](Json& element) {
        views.push_back({element.value("name", std::string()), element["buffer"].get<std::size_t>(),
                         element.value("byteOffset", std::uint64_t(0)),
                         element["byteLength"].get<std::uint64_t>(),
                         element.value("byteStride", std::uint64_t(0)), compressedDataOf(element)});
    });
    document.erase("bufferViews");
    return views;
}

/// Hidden from tinygltf, which may be built to decode them itself.
void takeCompressedPrimitives(Json& json, Document& document) {
    std::size_t meshes = 0;
    forEachObject(json, "meshes", [&](Json& mesh) {
        const std::size_t meshIndex = meshes++;
        std::size_t primitives = 0;
        forEachObject(mesh, "primitives", [&](Json& primitive) {
            const std::size_t primitiveIndex = primitives++;
            const Json::json_pointer place("/extensions/KHR_draco_mesh_compression");
            if (!primitive.contains(place)) return;
            CompressedPrimitive compressed{primitive[place]["bufferView"].get<std::size_t>(), {}};
            for (const auto& [name, id] : primitive[place]["attributes"].items()) {
                if (id.is_number_unsigned()) compressed.attributes.emplace(name, id.get<std::uint32_t>());
            }
            document.compressedPrimitives.emplace(std::pair(meshIndex, primitiveIndex),
                                                  std::move(compressed));
            primitive["extensions"].erase("KHR_draco_mesh_compression");
        });
    });
}

/// The image of an extension is used where a texture has no other.
void chooseTextureSources(Json& document) {
    forEachObject(document, "textures", [](Json& texture) {
        for (const char* place :
             {"/extensions/EXT_texture_webp/source", "/extensions/KHR_texture_basisu/source"}) {
            const Json::json_pointer source(place);
            if (!texture.contains("source") && texture.contains(source)) texture["source"] = texture[source];
        }
        texture.erase("extensions");
    });
}

std::vector<std::string> imageExtensionsOf(Json& document) {
    std::vector<std::string> extensions;
    const auto textures = document.find("textures");
    if (textures == document.end() || !textures->is_array()) return extensions;
    for (const Json& texture : *textures) extensions.push_back(imageExtension(texture));
    return extensions;
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

bool isNormalizable(const tinygltf::Accessor& accessor) {
    return accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
}

/// Whether an attribute has numbers that only KHR_mesh_quantization allows.
bool isQuantized(const std::string& attribute, const tinygltf::Accessor& accessor) {
    if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) return false;
    if (attribute.starts_with("TEXCOORD_")) return !accessor.normalized || !isNormalizable(accessor);
    return attribute == "POSITION" || attribute == "NORMAL" || attribute == "TANGENT";
}

/// Integers that lack "normalized" or the extension that allows them have only one meaning.
void repairEncodings(Document& document, const Host& host) {
    for (std::size_t i = 0; i < document.model.meshes.size(); ++i) {
        const tinygltf::Mesh& mesh = document.model.meshes[i];
        const auto note = [&](const std::string& text) {
            host.note(CANDELA_NOTE_REPAIRED, elementName("mesh", i, mesh.name), text);
        };
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            for (const auto& [name, index] : primitive.attributes) {
                tinygltf::Accessor& accessor = document.model.accessors.at(static_cast<std::size_t>(index));
                const bool isFraction = name.starts_with("COLOR_") || name.starts_with("WEIGHTS_");
                if (isFraction && isNormalizable(accessor) && !accessor.normalized) {
                    accessor.normalized = true;
                    note("integers in " + name + " without \"normalized\", taken as fractions");
                }
                if (document.quantized || !isQuantized(name, accessor)) continue;
                document.quantized = true;
                note("integers in " + name + " without KHR_mesh_quantization, read as it says");
            }
        }
    }
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
    Json json = parseDocument(text, host);
    checkExtensions(json, host);

    Document document;
    document.quantized = usesExtension(json, "KHR_mesh_quantization");
    document.imageExtensions = imageExtensionsOf(json);
    document.cages = readCageSettings(json, host);
    document.shadows = readShadowExtras(json, host);
    document.imageBasedLight = readImageBasedLight(json, host);
    Conformity conformity = conform(json, documentSchema(), host);
    document.faults = std::move(conformity.faults);
    document.lostGeometry = std::move(conformity.lostGeometry);
    document.animationPointers = takeAnimationPointers(json);
    fillChannelNodes(json);
    refuseIncompleteCameras(json, document.faults);
    fillDefaults(json, host);
    removeAmbiguousTransforms(json, host);
    moveIndices(json);
    chooseTextureSources(json);
    document.bufferSources = takeSources(json, "buffers");
    document.bufferViews = takeBufferViews(json);
    document.imageSources = takeSources(json, "images");
    document.skins = takeSkins(json);
    takeCompressedPrimitives(json, document);
    loadModel(document.model, json);
    repairEncodings(document, host);
    return document;
}

void loseGeometry(Document& document, const Failure& failure, const Host& host) {
    if (!document.lostGeometry) document.lostGeometry = failure;
    host.noteLeftOut(failure);
}

void requireUsable(const Document& document, const std::string& element) {
    const auto fault = document.faults.find(element);
    if (fault != document.faults.end()) throw fault->second;
}

void requireUsable(const Document& document, const std::string& element, const std::string& user) {
    const auto fault = document.faults.find(element);
    if (fault == document.faults.end()) return;
    // The fault may be about a part of the element: "accessor 7, sparse".
    throw Failure{user, fault->second.element + ": " + fault->second.reason};
}

}  // namespace candela_plugins::gltf
