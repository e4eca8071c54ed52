#pragma once

#include <deque>
#include <vector>

#include "container.h"
#include "document.h"
#include "host.h"

namespace candela_gltf {

/// Keeps what was decoded from data URIs alive; a deque, so that earlier elements stay where they are.
using Storage = std::deque<std::vector<std::uint8_t>>;

/// The bytes behind a URI: of a data URI decoded into `storage`, of a file as the host lends them.
Bytes loadUri(const std::string& uri, const std::string& element, Storage& storage, const Host& host);

/// Fills `document.buffers`. Each is as long as its byteLength says.
void loadBuffers(Document& document, const Container& container, Storage& storage, const Host& host);

/// The bytes of a buffer view. Throws `Failure` for `element` when it reaches beyond its buffer.
Bytes viewBytes(const Document& document, std::size_t bufferView, const std::string& element);

}  // namespace candela_gltf
