#pragma once

#include <map>
#include <vector>

#include "../common/host.h"
#include "deformation.h"
#include "document.h"
#include "materials.h"
#include "nodes.h"

namespace candela_plugins::gltf {

/// An added cage, with the data for its instances.
struct AddedCage {
    std::int32_t index = -1;
    std::uint32_t influenceCount = 0;  ///< Joints a vertex.
    std::uint32_t jointCount = 0;      ///< The highest joint of its vertices, plus one.
    std::uint32_t morphTargetCount = 0;
};

/// By mesh of the file.
using AddedCages = std::map<std::size_t, AddedCage>;

/// The cage of the mesh of a node; nullptr for none.
const AddedCage* cageOf(const Document& document, std::size_t node, const AddedCages& cages);

/// Adds the meshes of `document.cages` that are marked in `used`, except those without a face, and notes
/// what is left out. A cage that is broken is left out. `materials` gets copies for them. Progress goes from
/// `from` to `to`.
AddedCages addCages(Document& document, const std::vector<bool>& used, AddedMaterials& materials,
                    const Host& host, double from, double to);

/// Adds the cage instances of the nodes, with their skins and morph weights. Where node, skin and cage do not
/// fit together, the skin or the weights are left out, with a note.
void addCageInstances(const Document& document, const std::vector<DrawnNode>& drawn,
                      const std::vector<std::int32_t>& nodes, const AddedCages& cages, Skins& skins,
                      const Host& host);

}  // namespace candela_plugins::gltf
