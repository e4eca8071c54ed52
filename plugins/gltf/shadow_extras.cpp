#include "shadow_extras.h"

#include <nlohmann/json.hpp>

#include <cfloat>
#include <optional>
#include <string>

#include "../common/failure.h"

namespace candela_plugins::gltf {
namespace {

using Json = nlohmann::json;

/// The members of `extras` of one element.
class ExtrasReader {
  public:
    ExtrasReader(const Json& element, const char* noun, std::size_t index, const Host& host)
        : element_(element), noun_(noun), index_(index), host_(host) {}

    /// Blender wrote check boxes as 0 and 1 before its custom properties had a boolean type.
    std::optional<bool> flag(const char* key) const {
        const Json* value = find(key);
        if (!value) return std::nullopt;
        if (value->is_boolean()) return value->get<bool>();
        if (*value == 0 || *value == 1) return *value == 1;
        note(key, "expected true or false");
        return std::nullopt;
    }

    std::optional<float> zeroOrMore(const char* key) const {
        const Json* value = find(key);
        if (!value) return std::nullopt;
        const double number = value->is_number() ? value->get<double>() : -1.0;
        if (number >= 0.0 && number <= FLT_MAX) return static_cast<float>(number);
        note(key, "expected a number of 0 or more");
        return std::nullopt;
    }

  private:
    /// Extras may be of any type.
    const Json* find(const char* key) const {
        if (!element_.is_object()) return nullptr;
        const auto extras = element_.find("extras");
        if (extras == element_.end() || !extras->is_object()) return nullptr;
        const auto value = extras->find(key);
        return value == extras->end() ? nullptr : &*value;
    }

    void note(const char* key, const char* expectation) const {
        const auto name = element_.find("name");
        const bool named = name != element_.end() && name->is_string();
        const std::string element =
            elementName(noun_, index_, named ? name->get<std::string>() : std::string());
        host_.note(CANDELA_NOTE_REPAIRED, element + ", extras, " + key,
                   std::string(expectation) + ": the default is used");
    }

    const Json& element_;
    const char* noun_;
    std::size_t index_;
    const Host& host_;
};

/// The array at `pointer`; an empty one where there is none.
const Json& arrayAt(const Json& document, const char* pointer) {
    static const Json none = Json::array();
    const Json::json_pointer place(pointer);
    return document.contains(place) && document[place].is_array() ? document[place] : none;
}

}  // namespace

std::uint32_t castsNoShadow(const std::map<std::size_t, bool>& flags, std::size_t index) {
    const auto found = flags.find(index);
    return found != flags.end() && !found->second ? 1 : 0;
}

ShadowExtras readShadowExtras(const Json& document, const Host& host) {
    ShadowExtras extras;
    const Json& nodes = arrayAt(document, "/nodes");
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const ExtrasReader reader(nodes[i], "node", i, host);
        if (const auto casts = reader.flag("castsShadow")) extras.nodes.emplace(i, *casts);
    }
    const Json& lights = arrayAt(document, "/extensions/KHR_lights_punctual/lights");
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const ExtrasReader reader(lights[i], "light", i, host);
        if (const auto casts = reader.flag("castsShadow")) extras.lights.emplace(i, *casts);
        if (const auto radius = reader.zeroOrMore("radius")) extras.radii.emplace(i, *radius);
    }
    return extras;
}

}  // namespace candela_plugins::gltf
