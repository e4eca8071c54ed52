#pragma once

#include <map>
#include <vector>

#include "../common/host.h"
#include "document.h"
#include "host_material.h"
#include "images.h"
#include "uv_slots.h"

namespace candela_plugins::gltf {

/// The materials of the file, in its order.
struct AddedMaterials {
    std::vector<UvSlots> uvSlots;     ///< The sets of texture coordinates that it reads.
    std::vector<HostMaterial> added;  ///< As it was added; the names are those of the document.
    /// For materials of cages that have other sets of texture coordinates there: the host's index of the
    /// copy.
    std::map<std::int32_t, std::int32_t> cageCopies = {};
    std::int32_t defaultMaterial = -1;  ///< For primitives without a material; -1 where there are none.
};

/// Adds all materials of the file in order, so that the host's indices are the file's, and the default one
/// where a primitive of a mesh marked in `usedMeshes` has none.
AddedMaterials addMaterials(const Document& document, const AddedImages& images,
                            const std::vector<bool>& usedMeshes, const Host& host);

}  // namespace candela_plugins::gltf
