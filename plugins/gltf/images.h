#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "../common/host.h"
#include "buffers.h"
#include "document.h"

namespace candela_plugins::gltf {

/// The bytes of image `index` of the file. Throws `Failure` for `element` when it cannot be read.
Bytes imageFile(const Document& document, std::size_t index, const std::string& element, Storage& storage,
                const Host& host);

/// The host's indices of images; -1 for those that nothing uses, and for those that cannot be read.
struct AddedImages {
    std::vector<std::int32_t> indices;  ///< One for each image of the file.
    /// Roughness in G, 1 minus the glossiness in A of an image times a factor, by image and factor.
    std::map<std::pair<std::size_t, float>, std::int32_t> roughness;
};

/// Decodes the images that materials use, and adds them. Notes those that cannot be read. Progress goes from
/// `from` to `to`.
AddedImages addImages(const Document& document, Storage& storage, const Host& host, double from, double to);

}  // namespace candela_plugins::gltf
