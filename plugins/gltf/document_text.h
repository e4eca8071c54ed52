#pragma once

#include <nlohmann/json_fwd.hpp>

#include "../common/failure.h"
#include "../common/host.h"

namespace candela_plugins::gltf {

/// Parses the JSON text of a document, whose version is 2.x. What is not JSON, but what exporters write (NaN,
/// infinities, names that are not UTF-8, zeros behind the text, a version that is not text), is repaired and
/// noted. Throws `Failure` for anything else, and for glTF 1.0 and minimum versions beyond 2.0.
nlohmann::json parseDocument(const Bytes& text, const Host& host);

}  // namespace candela_plugins::gltf
