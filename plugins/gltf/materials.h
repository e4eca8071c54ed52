#pragma once

#include <array>
#include <vector>

#include "../common/host.h"
#include "buffers.h"
#include "document.h"

namespace candela_plugins::gltf {

/// Which sets of texture coordinates, 0 and 1, the textures of a material read.
using UvSets = std::array<bool, 2>;

/// The materials of the file, in its order.
struct AddedMaterials {
    std::vector<UvSets> uvSets;           ///< The sets of texture coordinates that it reads.
    std::vector<candela_material> added;  ///< As it was added; the names are those of the document.
};

/// Adds all materials of the file in order, so that the host's indices are the file's. `images` are
/// the host's indices of the file's images.
AddedMaterials addMaterials(const Document& document, const std::vector<std::int32_t>& images,
                            const Host& host);

/// Decodes the images that materials use, and adds them. Returns the host's index of each image of the
/// file, -1 for unused ones. Progress goes from `from` to `to`.
std::vector<std::int32_t> addImages(const Document& document, Storage& storage, const Host& host, double from,
                                    double to);

}  // namespace candela_plugins::gltf
