#include "polygons.h"

#include "failure.h"

namespace candela_gltf {

Polygons polygonsOfTriangles(std::vector<std::uint32_t> triangles) {
    Polygons polygons;
    polygons.sizes.assign(triangles.size() / 3, 3u);
    polygons.corners = std::move(triangles);
    return polygons;
}

Polygons recoverPolygons(const std::vector<std::uint32_t>& triangles, const std::string& element) {
    Polygons polygons;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const bool continues = i > 0 && triangles[i] == triangles[i - 3];
        if (!continues) {
            polygons.sizes.push_back(3);
            polygons.corners.insert(polygons.corners.end(), &triangles[i], &triangles[i] + 3);
            continue;
        }
        if (triangles[i + 1] != triangles[i - 1]) {
            throw Failure{
                element + ", FB_ngon_encoding",
                "triangle " + std::to_string(i / 3) + " begins at vertex " + std::to_string(triangles[i]) +
                    " like the one before, and goes on with vertex " + std::to_string(triangles[i + 1]) +
                    ", expected " + std::to_string(triangles[i - 1])};
        }
        ++polygons.sizes.back();
        polygons.corners.push_back(triangles[i + 2]);
    }
    return polygons;
}

}  // namespace candela_gltf
