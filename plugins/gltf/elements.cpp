#include "elements.h"

#include <utility>

#include "primitives.h"

namespace candela_plugins::gltf {

namespace {

constexpr Elements triangles{CANDELA_TRIANGLES, 3, "triangle"}, lines{CANDELA_LINES, 2, "line"},
    points{CANDELA_POINTS, 1, "point"};

/// Of mode LINES, LINE_LOOP or LINE_STRIP.
std::vector<std::uint32_t> linesOf(int mode, std::vector<std::uint32_t> corners, const std::string& element) {
    const std::string count = "has " + std::to_string(corners.size()) + " corners, expected ";
    if (mode == TINYGLTF_MODE_LINE) {
        if (corners.size() % 2 != 0) throw Failure{element, count + "an even number"};
        return corners;
    }
    if (corners.size() < 2) throw Failure{element, count + "2 or more"};
    std::vector<std::uint32_t> indices;
    indices.reserve(corners.size() * 2);
    for (std::size_t i = 1; i < corners.size(); ++i)
        indices.insert(indices.end(), {corners[i - 1], corners[i]});
    if (mode == TINYGLTF_MODE_LINE_LOOP) indices.insert(indices.end(), {corners.back(), corners.front()});
    return indices;
}

}  // namespace

const Elements& elementsOf(int mode) {
    if (hasTriangles(mode)) return triangles;
    return mode == TINYGLTF_MODE_POINTS ? points : lines;
}

Numbers<std::uint32_t> readElements(const Document& document, const tinygltf::Primitive& primitive,
                                    std::uint32_t vertices, const Host& host, const std::string& element) {
    const Elements& elements = elementsOf(primitive.mode);
    Numbers<std::uint32_t> corners = findCorners(document, primitive, vertices, element);
    const bool isList = primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == TINYGLTF_MODE_LINE;
    const std::size_t surplus = isList ? corners.size() % elements.corners : 0;
    if (surplus > 0 && surplus < corners.size()) {
        corners.edit().resize(corners.size() - surplus);
        host.note(CANDELA_NOTE_MISSING, element,
                  std::string("corners beyond the last whole ") + elements.name + ": left out");
    }
    const bool isWholeList = isList && corners.size() % elements.corners == 0;
    if (isWholeList || primitive.mode == TINYGLTF_MODE_POINTS) return corners;
    return Numbers(hasTriangles(primitive.mode)
                       ? triangulate(primitive.mode, std::move(corners).take(), element)
                       : linesOf(primitive.mode, std::move(corners).take(), element));
}

}  // namespace candela_plugins::gltf
