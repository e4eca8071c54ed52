#pragma once

#include <vector>

#include "document.h"
#include "host.h"

namespace candela_gltf {

/// Pushes every material of the file, in its order, so that the host's indices are the file's. `images` are
/// the host's indices of the file's images.
void pushMaterials(const Document& document, const std::vector<std::int32_t>& images, const Host& host);

}  // namespace candela_gltf
