#pragma once

#include <array>
#include <vector>

#include "document.h"
#include "host.h"

namespace candela_gltf {

/// Which sets of texture coordinates, 0 and 1, the textures of a material read.
using UvSets = std::array<bool, 2>;

/// One of each a material of the file.
struct PushedMaterials {
    std::vector<UvSets> uvSets;            ///< What texture coordinates it reads.
    std::vector<candela_material> pushed;  ///< As the host has it; the names are those of the document.
};

/// Pushes every material of the file, in its order, so that the host's indices are the file's. `images` are
/// the host's indices of the file's images.
PushedMaterials pushMaterials(const Document& document, const std::vector<std::int32_t>& images,
                              const Host& host);

}  // namespace candela_gltf
