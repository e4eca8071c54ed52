#include "topology.h"

#include "document.h"
#include "failure.h"

namespace candela_gltf {
namespace {

std::vector<std::uint32_t> fromStrip(const std::vector<std::uint32_t>& corners) {
    std::vector<std::uint32_t> triangles;
    triangles.reserve((corners.size() - 2) * 3);
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        // Every other triangle of a strip runs the other way round.
        const std::size_t odd = i % 2;
        triangles.insert(triangles.end(), {corners[i], corners[i + 1 + odd], corners[i + 2 - odd]});
    }
    return triangles;
}

std::vector<std::uint32_t> fromFan(const std::vector<std::uint32_t>& corners) {
    std::vector<std::uint32_t> triangles;
    triangles.reserve((corners.size() - 2) * 3);
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        triangles.insert(triangles.end(), {corners[i + 1], corners[i + 2], corners[0]});
    }
    return triangles;
}

}  // namespace

bool hasTriangles(int mode) {
    return mode >= TINYGLTF_MODE_TRIANGLES;
}

std::vector<std::uint32_t> triangulate(int mode, std::vector<std::uint32_t> corners,
                                       const std::string& element) {
    const std::string count = "has " + std::to_string(corners.size()) + " corners, expected ";
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        if (corners.size() % 3 != 0) throw Failure{element, count + "a multiple of 3"};
        return corners;
    }
    if (corners.size() < 3) throw Failure{element, count + "3 or more"};
    return mode == TINYGLTF_MODE_TRIANGLE_STRIP ? fromStrip(corners) : fromFan(corners);
}

}  // namespace candela_gltf
