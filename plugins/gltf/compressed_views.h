#pragma once

#include "../common/host.h"
#include "buffers.h"
#include "document.h"

namespace candela_plugins::gltf {

/// Decodes the buffer views that EXT_meshopt_compression or KHR_meshopt_compression compresses into
/// `storage`, on all threads of the host; `document.buffers` are loaded. A view that cannot be decoded is
/// read from its uncompressed buffer, with a note, or becomes a fault where that is not in the file.
void decodeViews(Document& document, Storage& storage, const Host& host);

}  // namespace candela_plugins::gltf
