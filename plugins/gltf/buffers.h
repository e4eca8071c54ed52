#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "../common/failure.h"
#include "../common/host.h"
#include "document.h"

namespace candela_plugins::gltf {

/// The two parts of a glTF file.
struct Container {
    Bytes json;
    std::optional<Bytes> binary;  ///< The BIN chunk of a .glb file.
};

/// Splits a .glb, which its first bytes distinguish from a .gltf, into its chunks. What a .glb has against
/// section 4.4 of the glTF 2.0 specification is noted; throws `Failure` when there is no whole JSON chunk.
Container openContainer(const Bytes& file, const Host& host);

/// Whether `uri` holds the data itself ("data:...").
bool isDataUri(const std::string& uri);

/// The bytes of a data URI (RFC 2397), in base64 or percent-encoded. Throws `Failure` for `element`.
std::vector<std::uint8_t> decodeDataUri(const std::string& uri, const std::string& element);

/// The path that a relative URI stands for, percent-decoded. Throws `Failure` for `element` when the URI has
/// a scheme or is badly encoded.
std::string pathOfUri(const std::string& uri, const std::string& element);

/// Owns the bytes decoded from data URIs and compressed data. A deque, whose elements do not move when it
/// grows.
using Storage = std::deque<std::vector<std::uint8_t>>;

/// The bytes of a URI: a data URI is decoded into `storage`, a file is read by the host. Throws `Failure` for
/// `element`.
Bytes loadUri(const std::string& uri, const std::string& element, Storage& storage, const Host& host);

/// Fills `document.buffers`. A buffer that cannot be read has a fault, and one of another length than its
/// byteLength is noted.
void loadBuffers(Document& document, const Container& container, Storage& storage, const Host& host);

/// A part of a buffer, which messages call `part`. Throws `Failure` for `element` when it reaches beyond the
/// buffer, or this has a fault.
Bytes bufferBytes(const Document& document, std::size_t buffer, std::uint64_t byteOffset,
                  std::uint64_t byteLength, const std::string& part, const std::string& element);

/// The bytes of a buffer view, decoded where they are compressed. Throws `Failure` for `element` when it
/// reaches beyond its buffer, or when either has a fault.
Bytes viewBytes(const Document& document, std::size_t bufferView, const std::string& element);

}  // namespace candela_plugins::gltf
