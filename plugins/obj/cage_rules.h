#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "../common/host.h"
#include "document.h"

namespace candela_plugins::obj {

/// The query of a request: "model.obj?subdivide=loop&level=3".
struct Query {
    bool subdivide = false;  ///< Polygons become cages; set by "subdivide" and by "level".
    candela_scheme scheme = CANDELA_SCHEME_CATMULL_CLARK;
    std::uint32_t level = 0;  ///< 1 to 8; 0: by the size on the screen.
};

/// Reads "subdivide", "subdivide=catmullClark|loop|bilinear" and "level=N", joined by '&'. `text` may be
/// NULL.
Query parseQuery(const char* text);

/// A sharp edge that a tag names.
struct SharpEdge {
    std::uint32_t vertex0 = 0, vertex1 = 0;  ///< Of the document; as the tag has them.
    float sharpness = 0.0f;
    const Tag* tag = nullptr;
    std::uint32_t lastPart = none;  ///< The last part in which this edge was found.
};

/// The rules of the cages of a file, from its tags. The defaults are those of OpenSubdiv's reader of its
/// regression shapes: boundaries sharp along edges but not at corners, texture coordinates linear.
struct CageRules {
    candela_boundary_interpolation boundary = CANDELA_BOUNDARY_EDGES;
    candela_face_varying_interpolation faceVarying = CANDELA_FACE_VARYING_ALL;
    candela_crease_method creaseMethod = CANDELA_CREASE_UNIFORM;
    candela_triangle_subdivision triangles = CANDELA_TRIANGLE_CATMULL_CLARK;
    std::unordered_map<std::uint64_t, SharpEdge>
        creases;  ///< By `edgeKey`. Of several tags the last one counts.
    std::unordered_map<std::uint32_t, float> cornerSharpness;  ///< By vertex.
    std::vector<bool> isHole;                                  ///< One a face; empty where there is no hole.
};

/// The same for both directions of an edge.
std::uint64_t edgeKey(std::uint32_t vertex0, std::uint32_t vertex1);

/// Reads the tags of the document, whose indices count from 0. The rules refer to the document.
CageRules readCageRules(const Document& document, candela_scheme scheme, const Host& host);

}  // namespace candela_plugins::obj
