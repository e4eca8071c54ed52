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
    std::int32_t defaultMaterial = -1;    ///< For primitives without a material; -1 where there are none.
};

/// Adds all materials of the file in order, so that the host's indices are the file's, and the default one
/// where a primitive of a mesh marked in `usedMeshes` has none. `images` are the host's indices of the file's
/// images.
AddedMaterials addMaterials(const Document& document, const std::vector<std::int32_t>& images,
                            const std::vector<bool>& usedMeshes, const Host& host);

/// The bytes of image `index` of the file. Throws `Failure` for `element` when it cannot be read.
Bytes imageFile(const Document& document, std::size_t index, const std::string& element, Storage& storage,
                const Host& host);

/// Decodes the images that materials use, and adds them. Returns the host's index of each image of the
/// file, -1 for those that nothing uses, and, with a note, for those that cannot be read. Progress goes from
/// `from` to `to`.
std::vector<std::int32_t> addImages(const Document& document, Storage& storage, const Host& host, double from,
                                    double to);

}  // namespace candela_plugins::gltf
