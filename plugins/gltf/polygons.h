#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace candela_gltf {

/// Faces of any size, one after the other.
struct Polygons {
    std::vector<std::uint32_t> sizes;    ///< Corners of each face.
    std::vector<std::uint32_t> corners;  ///< A vertex a corner.
};

/// Triangles, three vertices each, as polygons.
Polygons polygonsOfTriangles(std::vector<std::uint32_t> triangles);

/// The polygons that FB_ngon_encoding cut into triangles: consecutive triangles that have their first vertex
/// in common are the fan of one polygon. Throws `Failure` for `element` where a triangle does not go on with
/// the fan that it belongs to.
Polygons recoverPolygons(const std::vector<std::uint32_t>& triangles, const std::string& element);

}  // namespace candela_gltf
