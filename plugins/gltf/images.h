#pragma once

#include <vector>

#include "buffers.h"
#include "document.h"
#include "host.h"

namespace candela_gltf {

/// Decodes the images that materials use and pushes them. Returns the host's index of each image of the
/// file, -1 for those that nothing uses. Progress goes from `from` to `to`.
std::vector<std::int32_t> pushImages(const Document& document, Storage& storage, const Host& host,
                                     double from, double to);

}  // namespace candela_gltf
