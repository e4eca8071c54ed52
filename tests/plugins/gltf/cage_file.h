#pragma once

#include "loading.h"

namespace candela_test {

/// How the faces of a cage are encoded in the file.
enum class Faces { triangles, ngonEncoding };

/// `,"extensions":{"FB_ngon_encoding":{}}` for n-gons.
std::string facesMember(Faces faces);

/// Adds mesh 0 with these primitives (JSON objects, separated by commas) and the settings
/// "candela_subdivision", and node 0, which instances it. `more` are further members of the mesh.
void addCageMesh(GltfFile& file, const std::string& primitives, const std::string& settings,
                 const std::string& more = "");

/// A cube from -1 to 1 as exporters write it: six faces with four vertices each, with normals, and texture
/// coordinates of six squares side by side. Vertex 4 f + i is corner i of face f; face 0 is at +X,
/// 1 at -X, 2 at +Y, 3 at -Y, 4 at +Z, 5 at -Z.
GltfFile cubeFile(const std::string& settings = "{}", Faces faces = Faces::ngonEncoding);

/// A square in the plane z = 0 from (0, 0) to (1, 1): accessor 0 has its corners, and each vertex is a corner
/// of its one face. `attributes` go to the primitive's attributes and `members` to the primitive.
struct SquareMembers {
    std::string attributes, members, mesh;
};
void addSquareCage(GltfFile& file, const SquareMembers& more = {});

/// The only cage of a file.
candela::Cage cageOf(const GltfFile& file);

/// The index of the cage's vertex at `position`; fails the test when there is none.
std::uint32_t vertexAt(const candela::Cage& cage, glm::vec3 position);

}  // namespace candela_test
