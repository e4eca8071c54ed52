#pragma once

#include <vector>

#include "../common/host.h"
#include "buffers.h"
#include "document.h"

namespace candela_plugins::gltf {

/// Decodes the primitives of the meshes in `used` that KHR_draco_mesh_compression compresses into `storage`,
/// on all threads of the host; the buffer views are decoded. Their attributes and indices become accessors
/// over decoded buffer views. A primitive that cannot be decoded keeps its uncompressed accessors, with a
/// note, or becomes a fault where these have no data.
void decodePrimitives(Document& document, const std::vector<bool>& used, Storage& storage, const Host& host);

}  // namespace candela_plugins::gltf
