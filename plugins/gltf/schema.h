#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cfloat>
#include <cstddef>
#include <string_view>
#include <vector>

namespace candela_plugins::gltf {

enum class Kind {
    number,    ///< Within `min` and `max`.
    numbers,   ///< An array of exactly `length` numbers, each within `min` and `max`.
    integer,   ///< Within `min` and `max`.
    flag,      ///< true or false.
    text,      ///< A string.
    texts,     ///< An array of strings.
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
};

enum class Need { optional, required };
enum class Bound { included, excluded };

struct ObjectSchema;

struct Property {
    const char* name = "";
    Kind kind = Kind::object;
    Need need = Need::optional;
    double min = -FLT_MAX, max = FLT_MAX;
    Bound minBound = Bound::included;
    std::size_t length = 0;  ///< 0: any number of them.
    Target target = Target::accessors;
    const ObjectSchema* schema = nullptr;
};

/// The members that a JSON object may have.
struct ObjectSchema {
    const char* noun;  ///< The name of the object in messages; empty: it is omitted.
    std::vector<Property> properties;
    /// An index map also keeps the names that are one of these and a number, such as "JOINTS_" and "12".
    std::vector<std::string_view> numberedNames = {};
};

/// Checks `document` against `schema`. Throws `Failure` that names the element at fault. Members that
/// the schema does not have are removed, whole numbers written as 3.0 become integers where integers are
/// meant, and numbers become floating-point where numbers are meant. tinygltf, which ignores values of the
/// wrong type and truncates large integers, then reads checked values only.
void conform(nlohmann::json& document, const ObjectSchema& schema);

/// The part of a glTF 2.0 document that this plugin reads, with the limits the specification sets.
const ObjectSchema& documentSchema();

}  // namespace candela_plugins::gltf
