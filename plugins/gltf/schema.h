#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cfloat>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../common/failure.h"
#include "../common/host.h"

namespace candela_plugins::gltf {

enum class Kind {
    number,    ///< Within `min` and `max`; clamped to a bound that is set, unless `minBound` is excluded.
    numbers,   ///< An array of exactly `length` such numbers.
    integer,   ///< Within `min` and `max`.
    flag,      ///< true or false.
    text,      ///< A string, one of `values` where there are any.
    index,     ///< An index into the array `target`.
    indices,   ///< An array of indices into `target`.
    indexMap,  ///< An object whose members are indices into `target`; `schema` lists the names that are kept.
    indexMaps,  ///< An array of such objects.
    object,     ///< An object of form `schema`.
    list,       ///< An array of objects of form `schema`.
};

/// The arrays of a document that its indices point into.
enum class Target {
    accessors,
    buffers,
    bufferViews,
    cameras,
    images,
    lights,
    materials,
    meshes,
    nodes,
    samplers,
    scenes,
    skins,
    textures,
    variants,
};

enum class Need { optional, required };
enum class Bound { included, excluded };
/// What a wrong value of an optional member leads to: the member is left out, so that its default counts; or
/// the object that has it cannot be used.
enum class OnFault { useDefault, refuseObject };
/// What is lost without a member.
enum class Content { other, geometry };

struct ObjectSchema;

struct Property {
    const char* name = "";
    Kind kind = Kind::object;
    Need need = Need::optional;
    OnFault onFault = OnFault::useDefault;
    Content content = Content::other;
    double min = -FLT_MAX, max = FLT_MAX;
    Bound minBound = Bound::included;
    std::size_t length = 0;  ///< 0: any number of them.
    Target target = Target::accessors;
    const ObjectSchema* schema = nullptr;
    std::vector<std::string_view> values = {};
};

/// The members that a JSON object may have.
struct ObjectSchema {
    const char* noun;  ///< The name of the object in messages; empty: it is omitted.
    std::vector<Property> properties;
    /// An index map also keeps the names that are one of these and a number, such as "JOINTS_" and "12".
    std::vector<std::string_view> numberedNames = {};
    /// An index map without a usable member of this name cannot be used.
    std::string_view essentialName = {};
    /// The JSON text that takes the place of an element of a list that cannot be used. "{}" is an element
    /// with all defaults, which is noted; others are recorded as faults.
    const char* stub = "{}";
};

/// Elements that cannot be used, by what messages call them: "accessor 7 'x'". What uses one is left out.
using Faults = std::map<std::string, Failure>;

struct Conformity {
    Faults faults;
    std::optional<Failure> lostGeometry;  ///< The first reason why meshes or nodes are missing.
};

/// Checks `document` against `schema`, and repairs it: afterwards it has the form that the schema says. What
/// is repaired or left out is noted, but for elements that cannot be used, which become faults: who uses them
/// notes what is missing. Throws `Failure` only when a required member of the document itself is missing.
/// Members that the schema does not have are removed, whole numbers written as 3.0 become integers where
/// integers are meant, and numbers become floating-point where numbers are meant. tinygltf, which ignores
/// values of the wrong type and truncates large integers, then reads checked values only.
Conformity conform(nlohmann::json& document, const ObjectSchema& schema, const Host& host);

/// The part of a glTF 2.0 document that this plugin reads, with the limits the specification sets.
const ObjectSchema& documentSchema();

}  // namespace candela_plugins::gltf
