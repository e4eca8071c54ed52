#pragma once

#include <candela/cage.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace candela {

/// A cage of points and faces; its rules are the defaults.
Cage makeCage(std::string name, std::vector<glm::vec3> points,
              const std::vector<std::vector<std::uint32_t>>& faces);

Cage cube();
/// `around` × `along` quads, closed both ways.
Cage torus(std::uint32_t around, std::uint32_t along);
/// A base of `sides` corners, which is not planar, and `sides` triangles.
Cage pyramid(std::uint32_t sides);
/// `columns` × `rows` unit quads in the plane y = 0, open; vertex (i, j) at (i, 0, -j).
Cage sheet(std::uint32_t columns, std::uint32_t rows);
/// `valence` quads around one vertex, with a second ring of quads around them; open.
Cage star(std::uint32_t valence);
/// Adjacent polygons of 3 to 7 corners; those of 4 and more are not planar.
Cage mixedPolygons();
/// Three sheets that share a line of edges.
Cage threeSheets();

/// Triangulates all faces of a cage, for the Loop scheme.
Cage triangulated(const Cage& cage);

using Random = std::mt19937;

/// Moves all points at random by at most `amount` metres along each axis.
void jitter(Cage& cage, float amount, Random& random);

/// Every vertex has its own texture coordinate, shared by all faces around it.
void addSmoothUvs(Cage& cage);
/// Faces are assigned to two charts at random, and some corners get separate texture coordinates: seams that
/// close, end and cross.
void addUvsWithSeams(Cage& cage, Random& random);

/// Sharpness from semi-sharp to infinite on some edges and vertices.
void addRandomSharpness(Cage& cage, Random& random);

/// The two vertices of each edge, the lower index first; sorted.
std::vector<std::pair<std::uint32_t, std::uint32_t>> edgesOf(const Cage& cage);

}  // namespace candela
