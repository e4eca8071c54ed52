#pragma once

#include <map>
#include <vector>

#include "document.h"
#include "host.h"
#include "materials.h"

namespace candela_gltf {

/// A cage of the host, and what its nodes need to know of it.
struct PushedCage {
    std::int32_t index = -1;
    std::uint32_t influenceCount = 0;  ///< Joints a vertex.
    std::uint32_t jointCount = 0;      ///< The highest joint of its vertices, plus one.
    std::uint32_t morphTargetCount = 0;
};

/// By mesh of the file.
using PushedCages = std::map<std::size_t, PushedCage>;

/// The cage that a node of the file shows; nullptr for none.
const PushedCage* cageOf(const Document& document, std::size_t node, const PushedCages& cages);

/// Pushes the meshes of `document.cages` that are marked in `used`, but for those without a face, and notes
/// what is left out. Progress goes from `from` to `to`.
PushedCages pushCages(const Document& document, const std::vector<bool>& used,
                      const PushedMaterials& materials, const Host& host, double from, double to);

}  // namespace candela_gltf
