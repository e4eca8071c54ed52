#include "cage_settings.h"

#include <nlohmann/json.hpp>

#include <cfloat>
#include <cmath>

#include "../common/failure.h"

namespace candela_plugins::gltf {
namespace {

using Json = nlohmann::json;

constexpr const char* settingsKey = "candela_subdivision";
constexpr double maxNumber = 4294967295.0;
constexpr double maxLevel = 8.0;

template <typename Value>
struct NamedValue {
    const char* name;
    Value value;
};

constexpr NamedValue<candela_scheme> schemes[] = {{"catmullClark", CANDELA_SCHEME_CATMULL_CLARK},
                                                  {"loop", CANDELA_SCHEME_LOOP},
                                                  {"bilinear", CANDELA_SCHEME_BILINEAR}};
constexpr NamedValue<candela_boundary_interpolation> boundaries[] = {
    {"none", CANDELA_BOUNDARY_NONE},
    {"edges", CANDELA_BOUNDARY_EDGES},
    {"edgesAndCorners", CANDELA_BOUNDARY_EDGES_AND_CORNERS}};
constexpr NamedValue<candela_face_varying_interpolation> faceVaryings[] = {
    {"none", CANDELA_FACE_VARYING_NONE},
    {"cornersOnly", CANDELA_FACE_VARYING_CORNERS_ONLY},
    {"cornersPlus1", CANDELA_FACE_VARYING_CORNERS_PLUS1},
    {"cornersPlus2", CANDELA_FACE_VARYING_CORNERS_PLUS2},
    {"boundaries", CANDELA_FACE_VARYING_BOUNDARIES},
    {"all", CANDELA_FACE_VARYING_ALL}};
constexpr NamedValue<candela_crease_method> creaseMethods[] = {{"uniform", CANDELA_CREASE_UNIFORM},
                                                               {"chaikin", CANDELA_CREASE_CHAIKIN}};
constexpr NamedValue<candela_triangle_subdivision> triangleRules[] = {
    {"catmullClark", CANDELA_TRIANGLE_CATMULL_CLARK}, {"smooth", CANDELA_TRIANGLE_SMOOTH}};

template <typename Value, std::size_t count>
std::string namesOf(const NamedValue<Value> (&values)[count]) {
    std::string names;
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) names += i + 1 == count ? " or " : ", ";
        names += values[i].name;
    }
    return names;
}

/// Reads the member of one key.
class MemberReader {
  public:
    MemberReader(const Json& value, std::string element) : value_(value), element_(std::move(element)) {}

    template <typename Value, std::size_t count>
    Value enumerator(const NamedValue<Value> (&values)[count]) const {
        if (!value_.is_string()) fail("expected " + namesOf(values));
        const std::string& text = value_.get_ref<const std::string&>();
        for (const NamedValue<Value>& value : values) {
            if (text == value.name) return value.value;
        }
        fail("is '" + readable(text) + "', expected " + namesOf(values));
    }

    std::uint32_t level() const {
        constexpr const char* expected = "expected an integer from 1 to 8";
        if (!value_.is_number()) fail(expected);
        const double level = value_.get<double>();
        if (level != std::floor(level) || level < 1.0 || level > maxLevel) fail(expected);
        return static_cast<std::uint32_t>(level);
    }

    std::vector<SharpEdge> creases() const {
        std::vector<SharpEdge> creases;
        for (std::size_t i = 0; i < sizeOf("[vertex, vertex, sharpness]"); ++i) {
            const Json& entry = tuple(i, 3, "[vertex, vertex, sharpness]");
            creases.push_back({wholeNumber(entry[0], i), wholeNumber(entry[1], i), sharpness(entry[2], i)});
        }
        return creases;
    }

    std::vector<SharpVertex> corners() const {
        std::vector<SharpVertex> corners;
        for (std::size_t i = 0; i < sizeOf("[vertex, sharpness]"); ++i) {
            const Json& entry = tuple(i, 2, "[vertex, sharpness]");
            corners.push_back({wholeNumber(entry[0], i), sharpness(entry[1], i)});
        }
        return corners;
    }

    std::vector<std::uint32_t> holes() const {
        std::vector<std::uint32_t> holes;
        for (std::size_t i = 0; i < sizeOf("faces"); ++i) holes.push_back(wholeNumber(value_[i], i));
        return holes;
    }

    [[noreturn]] void fail(const std::string& reason) const { throw Failure{element_, reason}; }

  private:
    [[noreturn]] void failAt(std::size_t entry, const std::string& reason) const {
        throw Failure{element_ + " " + std::to_string(entry), reason};
    }

    std::size_t sizeOf(const char* entries) const {
        if (!value_.is_array()) fail(std::string("expected an array of ") + entries);
        return value_.size();
    }

    const Json& tuple(std::size_t entry, std::size_t size, const char* form) const {
        const Json& value = value_[entry];
        if (!value.is_array() || value.size() != size) failAt(entry, std::string("expected ") + form);
        return value;
    }

    std::uint32_t wholeNumber(const Json& value, std::size_t entry) const {
        if (!value.is_number()) failAt(entry, "expected the number of a vertex or a face");
        const double number = value.get<double>();
        if (number == std::floor(number) && number >= 0.0 && number <= maxNumber) {
            return static_cast<std::uint32_t>(number);
        }
        failAt(entry, "has a vertex or a face that is not an integer from 0 to 4294967295");
    }

    float sharpness(const Json& value, std::size_t entry) const {
        if (!value.is_number()) failAt(entry, "expected a sharpness");
        const double sharpness = value.get<double>();
        if (sharpness >= 0.0 && sharpness <= FLT_MAX) return static_cast<float>(sharpness);
        failAt(entry, "has a sharpness that is not 0 or more");
    }

    const Json& value_;
    std::string element_;
};

void readMember(const std::string& key, const Json& value, const std::string& element,
                CageSettings& settings) {
    const MemberReader reader(value, element + ", " + readable(key));
    if (key == "scheme") {
        settings.scheme = reader.enumerator(schemes);
    } else if (key == "level") {
        settings.level = reader.level();
    } else if (key == "boundaryInterpolation") {
        settings.boundaryInterpolation = reader.enumerator(boundaries);
    } else if (key == "faceVaryingInterpolation") {
        settings.faceVaryingInterpolation = reader.enumerator(faceVaryings);
    } else if (key == "creaseMethod") {
        settings.creaseMethod = reader.enumerator(creaseMethods);
    } else if (key == "triangleSubdivision") {
        settings.triangleSubdivision = reader.enumerator(triangleRules);
    } else if (key == "creases") {
        settings.creases = reader.creases();
    } else if (key == "corners") {
        settings.corners = reader.corners();
    } else if (key == "holes") {
        settings.holes = reader.holes();
    } else {
        reader.fail(
            "is not known, expected scheme, level, boundaryInterpolation, faceVaryingInterpolation, "
            "creaseMethod, triangleSubdivision, creases, corners or holes");
    }
}

CageSettings readSettings(const Json& value, const std::string& element) {
    if (!value.is_object()) throw Failure{element, "is not an object"};
    CageSettings settings;
    for (const auto& member : value.items()) readMember(member.key(), member.value(), element, settings);
    return settings;
}

std::string meshName(const Json& mesh, std::size_t index) {
    const auto name = mesh.find("name");
    const bool named = name != mesh.end() && name->is_string();
    return elementName("mesh", index, named ? name->get<std::string>() : std::string());
}

}  // namespace

std::map<std::size_t, CageSettings> readCageSettings(const nlohmann::json& document, const Host& host) {
    std::map<std::size_t, CageSettings> cages;
    const auto meshes = document.find("meshes");
    if (meshes == document.end() || !meshes->is_array()) return cages;
    for (std::size_t i = 0; i < meshes->size(); ++i) {
        const Json& mesh = (*meshes)[i];
        if (!mesh.is_object() || !mesh.contains("extras") || !mesh["extras"].is_object()) continue;
        const auto settings = mesh["extras"].find(settingsKey);
        if (settings == mesh["extras"].end()) continue;
        const std::string element = meshName(mesh, i);
        try {
            cages.emplace(i, readSettings(*settings, element + ", " + settingsKey));
        } catch (const Failure& failure) {
            host.note(CANDELA_NOTE_MISSING, failure.element, failure.reason + ": drawn without subdivision");
        }
    }
    return cages;
}

}  // namespace candela_plugins::gltf
