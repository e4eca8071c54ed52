#pragma once

#include <unordered_map>
#include <vector>

#include "document.h"
#include "query.h"

namespace candela_obj {

/// A sharp edge that a tag names.
struct SharpEdge {
    std::uint32_t vertex0 = 0, vertex1 = 0;  ///< Of the document; as the tag has them.
    float sharpness = 0.0f;
    const Tag* tag = nullptr;
    std::uint32_t lastPart = none;  ///< The last part found to have this edge.
};

/// What the tags of a file say of its cages. Where no tag speaks, the rules are those of OpenSubdiv's reader
/// of its regression shapes: boundaries sharp along edges but not at corners, texture coordinates linear.
struct CageRules {
    candela_boundary_interpolation boundary = CANDELA_BOUNDARY_EDGES;
    candela_face_varying_interpolation faceVarying = CANDELA_FACE_VARYING_ALL;
    candela_crease_method creaseMethod = CANDELA_CREASE_UNIFORM;
    candela_triangle_subdivision triangles = CANDELA_TRIANGLE_CATMULL_CLARK;
    std::unordered_map<std::uint64_t, SharpEdge> creases;  ///< By `edgeKey`. Of several tags the last counts.
    std::unordered_map<std::uint32_t, float> cornerSharpness;  ///< By vertex.
    std::vector<bool> isHole;                                  ///< One a face; empty where there is no hole.
};

/// The same for both directions of an edge.
std::uint64_t edgeKey(std::uint32_t vertex0, std::uint32_t vertex1);

/// Reads the tags of the document, whose indices count from 0. The rules refer to the document.
CageRules readCageRules(const Document& document, candela_scheme scheme, const Host& host);

}  // namespace candela_obj
