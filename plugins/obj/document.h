#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "../common/host.h"
#include "indexing.h"

namespace candela_plugins::obj {

struct Vec2 {
    float x = 0.0f, y = 0.0f;
};
struct Vec3 {
    float x = 0.0f, y = 0.0f, z = 0.0f;
};

/// An index that is not given.
inline constexpr std::uint32_t none = 0xFFFFFFFFu;

/// One vertex of one face, as indices from 0.
struct Corner {
    std::uint32_t vertex = none, uv = none, normal = none;
};

/// The state that the statements before a face have set.
struct FaceState {
    std::uint32_t object = 0;       ///< Index into `Document::objects`.
    std::uint32_t group = 0;        ///< Index into `Document::groups`.
    std::uint32_t material = none;  ///< Index into `Document::materials`.
    std::uint32_t smoothing = 0;    ///< The smoothing group; 0 is none.
    bool operator==(const FaceState&) const = default;
};

struct Face {
    std::uint32_t firstCorner = 0;  ///< It ends where the next one begins.
    std::uint32_t state = 0;        ///< Index into `Document::states`.
    std::uint32_t line = 0;         ///< Of its statement.
};

/// A line "t name ints/floats/strings ...", as OpenSubdiv's regression shapes have it.
struct Tag {
    std::string name;
    std::string place;  ///< Such as "line 12".
    std::vector<std::int64_t> integers;
    std::vector<float> numbers;
    std::vector<std::string> texts;
    std::size_t surplusWords = 0;  ///< Words beyond the counts of the tag.

    Failure failure(const std::string& reason) const {
        return {place, "t " + readable(name) + ": " + reason};
    }
};

/// The content of an OBJ file, with indices checked and counted from 0.
struct Document {
    std::vector<Vec3> positions;  ///< Metres.
    std::vector<Vec3> colors;     ///< Linear Rec.709, one a position; empty where no vertex has one.
    std::vector<Vec2> uvs;        ///< With (0, 0) at the first texel of the first row.
    std::vector<Vec3> normals;
    std::vector<Corner> corners;
    std::vector<Face> faces;
    std::vector<FaceState> states;
    NameIndex objects, groups,
        materials;  ///< Without a statement, the object and the group have the name "".
    std::vector<std::string> materialFiles;  ///< Named by mtllib.
    std::vector<Tag> tags;
    /// The first normal index out of range. It matters only where the faces are drawn as polygons: some of
    /// OpenSubdiv's shapes have such indices.
    std::optional<Failure> normalFault;

    std::uint32_t cornerCount(std::size_t face) const {
        const std::size_t end = face + 1 < faces.size() ? faces[face + 1].firstCorner : corners.size();
        return static_cast<std::uint32_t>(end - faces[face].firstCorner);
    }
    const FaceState& stateOf(std::size_t face) const { return states[faces[face].state]; }
};

/// Reads an OBJ file. Content other than polygons becomes notes. Progress goes up to `progressEnd`.
Document parseObj(const Bytes& file, const Host& host, double progressEnd);

}  // namespace candela_plugins::obj
