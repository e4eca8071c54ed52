#pragma once

#include <candela/plugin.h>
#include <nlohmann/json_fwd.hpp>

#include <map>
#include <vector>

#include "../common/host.h"

namespace candela_plugins::gltf {

struct SharpEdge {
    std::uint32_t vertex0 = 0, vertex1 = 0;
    float sharpness = 0.0f;
};

struct SharpVertex {
    std::uint32_t vertex = 0;
    float sharpness = 0.0f;
};

/// The settings in the extras of a mesh under "candela_subdivision" (docs/subdivision.md, "Cages in glTF").
/// Vertices and faces are counted through the primitives of the mesh; whether they exist has not been
/// checked.
struct CageSettings {
    candela_scheme scheme = CANDELA_SCHEME_CATMULL_CLARK;
    candela_boundary_interpolation boundaryInterpolation = CANDELA_BOUNDARY_EDGES_AND_CORNERS;
    candela_face_varying_interpolation faceVaryingInterpolation = CANDELA_FACE_VARYING_CORNERS_ONLY;
    candela_crease_method creaseMethod = CANDELA_CREASE_UNIFORM;
    candela_triangle_subdivision triangleSubdivision = CANDELA_TRIANGLE_CATMULL_CLARK;
    std::uint32_t level = 0;  ///< 1 to 8; 0: by the size on the screen.
    std::vector<SharpEdge> creases;
    std::vector<SharpVertex> corners;
    std::vector<std::uint32_t> holes;
};

/// The settings of the meshes that are cages, by the index of the mesh. `document` need not be well-formed
/// elsewhere. A mesh with wrong settings is no cage, with a note that names mesh and key.
std::map<std::size_t, CageSettings> readCageSettings(const nlohmann::json& document, const Host& host);

}  // namespace candela_plugins::gltf
