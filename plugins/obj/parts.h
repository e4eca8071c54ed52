#pragma once

#include <string>
#include <vector>

#include "../common/host.h"
#include "cage_rules.h"
#include "document.h"
#include "materials.h"

namespace candela_plugins::obj {

/// Faces that become one mesh or one cage, and lines and points that become another mesh.
struct Part {
    std::string name;
    std::vector<std::uint32_t> faces;          ///< In the order of the file.
    std::vector<std::uint32_t> looseElements;  ///< Likewise.
};

enum class SplitAt {
    objects,           ///< 'o': the groups of a cage are one surface.
    objectsAndGroups,  ///< 'o' and 'g'.
};

/// The parts of the file in the order in which they begin; faces of the same names are one part, wherever
/// they stand. Its name is that of the object, of the group, or "object/group".
std::vector<Part> splitFaces(const Document& document, SplitAt splitAt);

/// Adds a root node at `origin` with the mesh, -1 for none, and returns its index.
std::int32_t addNode(const std::string& name, const Vec3& origin, std::int32_t mesh, const Host& host);

/// Adds the faces as polygons, and lines and points: a mesh and a node of each kind for each object and each
/// of its groups. `materials` holds those of the document. Progress goes from `from` to 1.
void addMeshes(Document& document, const std::vector<AddedMaterial>& materials, const Host& host,
               double from);

/// Adds the lines and points of a part: a mesh and a node.
void addLooseElements(const Document& document, const Part& part, const std::vector<AddedMaterial>& materials,
                      const Host& host);

/// Adds the faces as cages: one with its node for each object. `materials` holds those of the
/// document. Progress goes from `from` to 1.
void addCages(const Document& document, const Query& query, const std::vector<AddedMaterial>& materials,
              const Host& host, double from);

}  // namespace candela_plugins::obj
