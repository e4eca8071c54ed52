#pragma once

#include <string>
#include <vector>

#include "failure.h"

namespace candela_gltf {

/// Whether `uri` carries its data itself ("data:...").
bool isDataUri(const std::string& uri);

/// The bytes of a data URI (RFC 2397), in base64 or percent-encoded. Throws `Failure` for `element`.
std::vector<std::uint8_t> decodeDataUri(const std::string& uri, const std::string& element);

/// The path that a relative URI stands for, percent-decoded. Throws `Failure` for `element` when the URI has
/// a scheme or is badly encoded.
std::string pathOfUri(const std::string& uri, const std::string& element);

}  // namespace candela_gltf
