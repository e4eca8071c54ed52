#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cfloat>
#include <cstddef>
#include <string_view>
#include <vector>

namespace candela_gltf {

enum class Kind {
    number,     ///< Within `least` and `most`.
    numbers,    ///< An array of exactly `length` numbers, each within `least` and `most`.
    integer,    ///< Within `least` and `most`.
    flag,       ///< true or false.
    text,       ///< A string.
    texts,      ///< An array of strings.
    index,      ///< An index into the array `target`.
    indices,    ///< An array of indices into `target`.
    indexMap,   ///< An object whose members are indices into `target`; `shape` lists the names that are kept.
    indexMaps,  ///< An array of such objects.
    object,     ///< An object of form `shape`.
    list,       ///< An array of objects of form `shape`.
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

struct Shape;

struct Property {
    const char* name = "";
    Kind kind = Kind::object;
    Need need = Need::optional;
    double least = -FLT_MAX, most = FLT_MAX;
    Bound minBound = Bound::included;
    std::size_t length = 0;  ///< 0: any number of them.
    Target target = Target::accessors;
    const Shape* shape = nullptr;
};

/// The form of a JSON object.
struct Shape {
    const char* noun;  ///< What a message calls the object; empty: the message leaves it out.
    std::vector<Property> properties;
    /// An index map also keeps the names that are one of these and a number, such as "JOINTS_" and "12".
    std::vector<std::string_view> numberedNames = {};
};

/// Checks `document` against `shape` and throws `Failure` naming the element at fault. Members that have no
/// place in the shape are taken out, whole numbers written as 3.0 become integers where integers are meant,
/// and numbers become floating-point where numbers are meant. So the reader behind it sees only what has been
/// checked: tinygltf drops values of the wrong type without a word and cuts large integers.
void conform(nlohmann::json& document, const Shape& shape);

}  // namespace candela_gltf
