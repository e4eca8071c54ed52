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

/// An index that is not given; of a vertex, one that cannot be read.
inline constexpr std::uint32_t none = 0xFFFFFFFFu;
/// An index of nothing: there are fewer elements.
inline constexpr std::uint32_t outOfRange = 0xFFFFFFFEu;

/// One vertex of one face, as indices from 0. They are in range after `repairFaces`.
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

/// A polyline ("l") or points ("p").
struct LooseElement {
    candela_topology topology = CANDELA_LINES;
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

/// The first of several faults of a kind.
struct LineFault {
    std::size_t line = 0;
    Failure failure;
};

/// The content of an OBJ file, with indices counted from 0.
struct Document {
    std::vector<Vec3> positions;  ///< Metres, relative to `origin`. x is NaN where one is not usable.
    std::vector<Vec3> residuals;  ///< What the positions lack of the file's numbers; empty near the origin.
    Vec3 origin;                  ///< Set by `recentre`.
    std::vector<Vec3> colors;     ///< Linear Rec.709, one a position; empty where no vertex has one.
    std::vector<Vec2> uvs;        ///< With (0, 0) at the first texel of the first row; u may be NaN likewise.
    std::vector<Vec3> normals;    ///< x may be NaN likewise.
    std::vector<Corner> corners;
    std::vector<Face> faces;
    std::vector<Corner> looseCorners;  ///< Their vertices may be none and out of range.
    std::vector<LooseElement> looseElements;
    std::vector<FaceState> states;
    NameIndex objects, groups,
        materials;            ///< Without a statement, the object and the group have the name "".
    NameIndex materialFiles;  ///< Named by mtllib.
    std::vector<Tag> tags;
    std::optional<LineFault> vertexFault;     ///< The first vertex whose coordinates are not usable.
    std::optional<LineFault> faceFault;       ///< The first corner of a face that names no vertex.
    std::vector<std::uint32_t> leftOutFaces;  ///< Their numbers in the file from 0, ascending.

    std::uint32_t cornerCount(std::size_t face) const {
        const std::size_t end = face + 1 < faces.size() ? faces[face + 1].firstCorner : corners.size();
        return static_cast<std::uint32_t>(end - faces[face].firstCorner);
    }
    std::uint32_t looseCornerCount(std::size_t element) const {
        const std::size_t end =
            element + 1 < looseElements.size() ? looseElements[element + 1].firstCorner : looseCorners.size();
        return static_cast<std::uint32_t>(end - looseElements[element].firstCorner);
    }
    const FaceState& stateOf(std::size_t face) const { return states[faces[face].state]; }
};

class Statement;

/// Reads the rest of a statement "t". Throws `Failure` where it does not hold what its counts announce.
Tag parseTag(Statement& statement);

/// Reads an OBJ file. What cannot be read, and content other than polygons, lines and points, becomes notes.
/// Progress goes up to `progressEnd`. Throws `Failure` for a file without geometry.
Document parseObj(const Bytes& file, const Host& host, double progressEnd);

/// What becomes of the faces of a document.
enum class Surface { polygons, cages };

/// Leaves out faces that cannot be drawn: with fewer than three corners, or with a vertex that is not there
/// or has no usable coordinates; of cages, also those that pass through a vertex twice. Faces keep texture
/// coordinates, and those of polygons normals, only where all of their corners have usable ones. Afterwards
/// all indices are in range. What is lost becomes notes. Throws the first fault where no face is left of
/// some.
void repairFaces(Document& document, Surface surface, const Host& host);

/// Leaves out all lines and points, which becomes notes.
void leaveOutLooseElements(Document& document, const Host& host);

/// Notes the vertices of lines and points that are not there or have no usable coordinates, which are not
/// drawn. Afterwards texture coordinates are usable or none.
void repairLooseElements(Document& document, const Host& host);

/// Moves an object that is small against its distance from the origin, as survey coordinates are, to the
/// origin, and keeps its place in `Document::origin`: the precision of the file is lost otherwise. Indices
/// are in range.
void recentre(Document& document);

}  // namespace candela_plugins::obj
