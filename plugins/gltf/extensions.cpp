#include "extensions.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "extension_table.h"

namespace candela_plugins::gltf {
namespace {

using Json = nlohmann::json;

const Extension* find(std::string_view name) {
    const auto found = std::find_if(std::begin(extensionTable), std::end(extensionTable),
                                    [&](const Extension& extension) { return extension.name == name; });
    return found == std::end(extensionTable) ? nullptr : found;
}

/// What a material looks like is no matter of shape, whoever defines the extension.
bool isOfMaterials(std::string_view name) {
    return name.find("_materials_") != std::string_view::npos;
}

/// Extensions in whose objects there may be further ones.
bool isRead(const Extension& extension) {
    return extension.support == Support::drawn || extension.support == Support::partly;
}

std::string lossText(const std::string& name) {
    if (const Extension* extension = find(name)) return std::string(extension->loss);
    if (isOfMaterials(name)) return "a part of its look (" + readable(name) + ")";
    return "what '" + readable(name) + "' adds to it, an extension that is not known";
}

struct Noun {
    std::string_view array;
    const char* noun;
};

constexpr Noun nouns[] = {
    {"accessors", "accessor"}, {"animations", "animation"}, {"bufferViews", "bufferView"},
    {"buffers", "buffer"},     {"cameras", "camera"},       {"channels", "channel"},
    {"images", "image"},       {"lights", "light"},         {"materials", "material"},
    {"meshes", "mesh"},        {"nodes", "node"},           {"primitives", "primitive"},
    {"samplers", "sampler"},   {"scenes", "scene"},         {"skins", "skin"},
    {"textures", "texture"}};

std::string nameOf(const Json& element) {
    const auto name = element.is_object() ? element.find("name") : element.end();
    return element.is_object() && name != element.end() && name->is_string() ? name->get<std::string>()
                                                                             : std::string();
}

/// Notes the extensions of an object and of what is in it.
class LossFinder {
  public:
    explicit LossFinder(const Host& host) : host_(host) {}

    /// Extensions lie a few levels deep; what is nested deeper belongs to no glTF element.
    void visit(const Json& object, const std::string& element, int depth) const {
        constexpr int maxDepth = 8;
        if (!object.is_object() || depth > maxDepth) return;
        for (const auto& member : object.items()) {
            if (member.key() == "extras") continue;
            if (member.key() == "extensions") {
                noteExtensions(member.value(), element, depth);
            } else if (member.value().is_array()) {
                visitArray(member.value(), member.key(), element, depth);
            } else {
                visit(member.value(), below(element, member.key()), depth + 1);
            }
        }
    }

  private:
    static std::string below(const std::string& element, const std::string& member) {
        return element.empty() ? member : element + ", " + member;
    }

    void visitArray(const Json& array, const std::string& key, const std::string& element, int depth) const {
        const auto noun =
            std::find_if(std::begin(nouns), std::end(nouns), [&](const Noun& n) { return n.array == key; });
        if (noun == std::end(nouns)) return;
        for (std::size_t i = 0; i < array.size(); ++i) {
            if (!array[i].is_object()) continue;
            visit(array[i], below(element, elementName(noun->noun, i, nameOf(array[i]))), depth + 1);
        }
    }

    void noteExtensions(const Json& extensions, const std::string& element, int depth) const {
        if (!extensions.is_object()) return;
        for (const auto& extension : extensions.items()) {
            const std::string& name = extension.key();
            const Extension* known = find(name);
            if (known && isRead(*known)) visit(extension.value(), element, depth + 1);
            const std::string loss = lossText(name);
            if (!loss.empty()) host_.note(CANDELA_NOTE_MISSING, element, loss);
        }
    }

    const Host& host_;
};

std::vector<std::string> extensionList(const Json& document, const char* member) {
    std::vector<std::string> names;
    const auto list = document.find(member);
    if (list == document.end() || !list->is_array()) return names;
    for (const Json& name : *list) {
        if (name.is_string()) names.push_back(name.get<std::string>());
    }
    return names;
}

/// A member of an object; null where it has none.
const Json& memberOf(const Json& object, const char* name) {
    static const Json null;
    if (!object.is_object()) return null;
    const auto found = object.find(name);
    return found == object.end() ? null : *found;
}

}  // namespace

void checkExtensions(const Json& document, const Host& host) {
    for (const std::string& name : extensionList(document, "extensionsRequired")) {
        if (find(name) || isOfMaterials(name)) continue;
        throw Failure{"extensionsRequired", "extension '" + readable(name) + "' is not supported"};
    }
    LossFinder(host).visit(document, "", 0);
}

bool usesExtension(const Json& document, const char* name) {
    for (const char* member : {"extensionsUsed", "extensionsRequired"}) {
        const std::vector<std::string> names = extensionList(document, member);
        if (std::find(names.begin(), names.end(), name) != names.end()) return true;
    }
    return false;
}

std::string imageExtension(const Json& texture) {
    constexpr const char* names[] = {"EXT_texture_avif", "MSFT_texture_dds"};
    for (const char* name : names) {
        if (!memberOf(memberOf(texture, "extensions"), name).is_null()) return name;
    }
    return {};
}

}  // namespace candela_plugins::gltf
