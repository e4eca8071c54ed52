#include "schema.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <string_view>

#include "../common/failure.h"

namespace candela_plugins::gltf {
namespace {

using Json = nlohmann::json;

struct TargetArray {
    const char* pointer;
    const char* noun;
};

constexpr TargetArray targetArrays[] = {
    {"/accessors", "accessor"},
    {"/buffers", "buffer"},
    {"/bufferViews", "bufferView"},
    {"/cameras", "camera"},
    {"/images", "image"},
    {"/extensions/KHR_lights_punctual/lights", "light"},
    {"/materials", "material"},
    {"/meshes", "mesh"},
    {"/nodes", "node"},
    {"/samplers", "sampler"},
    {"/scenes", "scene"},
    {"/skins", "skin"},
    {"/textures", "texture"},
    {"/extensions/KHR_materials_variants/variants", "variant"},
};

/// The element being validated. Its text is built only for a message.
struct Place {
    const Place* parent = nullptr;
    const char* noun = "";
    std::ptrdiff_t index = -1;
    const Json* value = nullptr;

    std::string text() const {
        const std::string above = parent ? parent->text() : std::string();
        if (!*noun) return above;
        return above.empty() ? own() : above + ", " + own();
    }

  private:
    std::string own() const {
        if (index < 0) return noun;
        const bool named = value->is_object() && value->contains("name") && (*value)["name"].is_string();
        const std::string name = named ? (*value)["name"].get<std::string>() : std::string();
        return elementName(noun, static_cast<std::size_t>(index), name);
    }
};

std::string shown(double number) {
    char text[32];
    const bool whole = number == std::floor(number) && std::abs(number) < 1e15;
    std::snprintf(text, sizeof text, whole ? "%.0f" : "%.9g", number);
    return text;
}

bool isNumbered(std::string_view name, std::string_view prefix) {
    if (!name.starts_with(prefix) || name.size() == prefix.size()) return false;
    name.remove_prefix(prefix.size());
    return name.find_first_not_of("0123456789") == std::string_view::npos;
}

bool isKnown(const std::string& name, const ObjectSchema& schema) {
    return std::any_of(schema.properties.begin(), schema.properties.end(),
                       [&](const Property& property) { return name == property.name; }) ||
           std::any_of(schema.numberedNames.begin(), schema.numberedNames.end(),
                       [&](std::string_view prefix) { return isNumbered(name, prefix); });
}

std::string rangeText(const Property& p) {
    const bool below = p.min > -FLT_MAX, above = p.max < FLT_MAX;
    const bool excluded = p.minBound == Bound::excluded;
    if (below && above) return shown(p.min) + " to " + shown(p.max);
    if (below) return excluded ? "more than " + shown(p.min) : shown(p.min) + " or more";
    return above ? shown(p.max) + " or less" : "a number that single precision can hold";
}

/// A bound that numbers are clamped to.
bool isSet(double bound) {
    return std::abs(bound) < FLT_MAX;
}

class Checker {
  public:
    Checker(const Json& document, const Host& host) : host_(host) {
        for (std::size_t i = 0; i < std::size(targetArrays); ++i) {
            const Json::json_pointer pointer(targetArrays[i].pointer);
            const bool present = document.contains(pointer) && document[pointer].is_array();
            targetSizes_[i] = present ? document[pointer].size() : 0;
        }
    }

    void checkObject(Json& object, const ObjectSchema& schema, const Place& place) {
        if (!object.is_object()) fail(place, "is not an object");
        removeUnknown(object, schema);
        for (const Property& property : schema.properties) {
            const auto found = object.find(property.name);
            if (found != object.end()) {
                if (!isUsable(*found, property, place)) object.erase(found);
            } else if (property.need == Need::required) {
                fail(place, std::string("\"") + property.name + "\" is missing");
            }
        }
    }

    Conformity take() { return std::move(result_); }

  private:
    [[noreturn]] static void fail(const Place& place, const std::string& reason) {
        throw Failure{place.text(), reason};
    }

    static void removeUnknown(Json& object, const ObjectSchema& schema) {
        for (auto member = object.begin(); member != object.end();) {
            member = isKnown(member.key(), schema) ? std::next(member) : object.erase(member);
        }
    }

    /// False, and a note, where the member is to be left out. Throws where its object cannot be used.
    bool isUsable(Json& value, const Property& property, const Place& parent) {
        try {
            checkValue(value, property, parent);
            return true;
        } catch (const Failure& failure) {
            if (property.need == Need::required || property.onFault == OnFault::refuseObject) throw;
            if (property.content == Content::geometry) loseGeometry(failure);
            noteUnusable(failure, property);
            return false;
        }
    }

    void noteUnusable(const Failure& failure, const Property& property) const {
        if (std::string_view(property.name) == "name") return;
        const bool isPart = property.kind == Kind::index || property.kind == Kind::indexMaps ||
                            property.kind == Kind::object || property.kind == Kind::list;
        if (isPart) return host_.noteLeftOut(failure);
        noteDefault(failure);
    }

    void noteDefault(const Failure& failure) const {
        host_.note(CANDELA_NOTE_REPAIRED, failure.element, failure.reason + ": the default is used");
    }

    void loseGeometry(const Failure& failure) {
        if (!result_.lostGeometry) result_.lostGeometry = failure;
    }

    void checkValue(Json& value, const Property& property, const Place& parent) {
        const Place place{&parent, property.name, -1, &value};
        switch (property.kind) {
            case Kind::number:
                return checkNumber(value, property, place);
            case Kind::numbers:
                return checkNumbers(value, property, place);
            case Kind::integer:
                return checkInteger(value, property, place);
            case Kind::flag:
                return require(value.is_boolean(), place, "expected true or false");
            case Kind::text:
                return checkText(value, property, place);
            case Kind::index:
                return checkIndex(value, property.target, place);
            case Kind::indices:
                return checkIndices(value, property, place);
            case Kind::indexMap:
                require(value.is_object(), place, "is not an object");
                return checkIndexMap(value, property, parent);
            case Kind::indexMaps:
                return checkIndexMaps(value, property, parent);
            case Kind::object: {
                const Place object{&parent, property.schema->noun, -1, &value};
                return checkObject(value, *property.schema, object);
            }
            case Kind::list:
                return checkList(value, property, parent);
        }
    }

    static void require(bool fulfilled, const Place& place, const char* expectation) {
        if (!fulfilled) fail(place, expectation);
    }

    void checkNumber(Json& value, const Property& property, const Place& place) const {
        value = checkedNumber(value, property, place);
    }

    double checkedNumber(const Json& value, const Property& property, const Place& place) const {
        require(value.is_number(), place, "expected a number");
        const double number = value.get<double>();
        const bool excluded = property.minBound == Bound::excluded;
        const bool below = excluded ? number <= property.min : number < property.min;
        if (!below && number <= property.max) return number;
        const double bound = below ? property.min : property.max;
        if (!isSet(bound) || excluded) {
            fail(place, "is " + shown(number) + ", expected " + rangeText(property));
        }
        host_.note(CANDELA_NOTE_REPAIRED, place.text(),
                   (below ? "less than " : "more than ") + shown(bound) + ", clamped");
        return bound;
    }

    void checkNumbers(Json& value, const Property& property, const Place& place) const {
        require(value.is_array(), place, "expected an array of numbers");
        if (property.length > 0 && value.size() != property.length) {
            fail(place, "has " + std::to_string(value.size()) + " numbers, expected " +
                            std::to_string(property.length));
        }
        for (Json& number : value) checkNumber(number, property, place);
    }

    static void checkInteger(Json& value, const Property& property, const Place& place) {
        require(value.is_number(), place, "expected an integer");
        const double number = value.get<double>();
        if (number != std::floor(number)) fail(place, "is " + shown(number) + ", expected an integer");
        if (number < property.min || number > property.max) {
            fail(place, "is " + shown(number) + ", expected " + rangeText(property));
        }
        if (number < 0) {
            value = static_cast<std::int64_t>(number);
        } else {
            value = static_cast<std::uint64_t>(number);
        }
    }

    static void checkText(const Json& value, const Property& property, const Place& place) {
        require(value.is_string(), place, "expected a string");
        if (property.values.empty()) return;
        const std::string text = value.get<std::string>();
        const auto& values = property.values;
        if (std::find(values.begin(), values.end(), text) != values.end()) return;
        std::string expected;
        for (const std::string_view& known : values) {
            const bool isLast = &known == &values.back();
            expected += (expected.empty() ? "" : isLast ? " or " : ", ") + std::string(known);
        }
        fail(place, "is '" + readable(text) + "', expected " + expected);
    }

    void checkIndex(Json& value, Target target, const Place& place) const {
        const TargetArray& array = targetArrays[static_cast<std::size_t>(target)];
        const std::size_t size = targetSizes_[static_cast<std::size_t>(target)];
        if (!value.is_number() || value.get<double>() != std::floor(value.get<double>())) {
            fail(place, std::string("expected the index of a ") + array.noun);
        }
        const double index = value.get<double>();
        if (index < 0 || index >= static_cast<double>(size)) {
            fail(place, std::string(array.noun) + " " + shown(index) + " does not exist: the file has " +
                            std::to_string(size));
        }
        value = static_cast<std::uint64_t>(index);
    }

    /// Of a list of optional members only the wrong ones are left out.
    void checkIndices(Json& value, const Property& property, const Place& place) {
        require(value.is_array(), place, "expected an array of indices");
        const bool keepsRest = property.need == Need::optional && property.onFault == OnFault::useDefault;
        Json kept = Json::array();
        for (Json& index : value) {
            try {
                checkIndex(index, property.target, place);
                kept.push_back(std::move(index));
            } catch (const Failure& failure) {
                if (!keepsRest) throw;
                if (property.content == Content::geometry) loseGeometry(failure);
                host_.noteLeftOut(failure);
            }
        }
        value = std::move(kept);
    }

    void checkIndexMap(Json& value, const Property& property, const Place& parent) const {
        removeUnknown(value, *property.schema);
        for (auto member = value.begin(); member != value.end();) {
            const std::string noun = std::string(property.schema->noun) + " " + member.key();
            try {
                checkIndex(*member, property.target, Place{&parent, noun.c_str(), -1, &*member});
                ++member;
            } catch (const Failure& failure) {
                if (member.key() == property.schema->essentialName) throw;
                host_.noteLeftOut(failure);
                member = value.erase(member);
            }
        }
    }

    void checkIndexMaps(Json& value, const Property& property, const Place& parent) const {
        require(value.is_array(), Place{&parent, property.name, -1, &value}, "expected an array");
        for (std::size_t i = 0; i < value.size(); ++i) {
            const Place place{&parent, property.name, static_cast<std::ptrdiff_t>(i), &value[i]};
            require(value[i].is_object(), place, "is not an object");
            checkIndexMap(value[i], property, place);
        }
    }

    void checkList(Json& value, const Property& property, const Place& parent) {
        require(value.is_array(), Place{&parent, property.name, -1, &value}, "expected an array");
        for (std::size_t i = 0; i < value.size(); ++i) {
            const Place place{&parent, property.schema->noun, static_cast<std::ptrdiff_t>(i), &value[i]};
            try {
                checkObject(value[i], *property.schema, place);
            } catch (const Failure& failure) {
                if (property.content == Content::geometry) loseGeometry(failure);
                replace(value[i], *property.schema, place, failure);
            }
        }
    }

    void replace(Json& element, const ObjectSchema& schema, const Place& place, const Failure& failure) {
        Json stub = Json::parse(schema.stub);
        const bool isDefault = stub.empty();
        if (isDefault) noteDefault(failure);
        if (!isDefault) result_.faults.emplace(place.text(), failure);
        const bool named = element.is_object() && element.contains("name") && element["name"].is_string();
        if (named) stub["name"] = element["name"];
        element = std::move(stub);
    }

    const Host& host_;
    Conformity result_;
    std::array<std::size_t, std::size(targetArrays)> targetSizes_{};
};

}  // namespace

Conformity conform(nlohmann::json& document, const ObjectSchema& schema, const Host& host) {
    Checker checker(document, host);
    checker.checkObject(document, schema, Place{nullptr, schema.noun, -1, &document});
    return checker.take();
}

}  // namespace candela_plugins::gltf
