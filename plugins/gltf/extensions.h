#pragma once

#include <nlohmann/json_fwd.hpp>

#include "host.h"

namespace candela_gltf {

/// Throws `Failure` when the document asks for another version than 2.x, or for a minimum above 2.0.
void checkVersion(const nlohmann::json& document);

/// Throws `Failure` for an unknown extension of extensionsRequired, and notes the unknown ones of
/// extensionsUsed.
void checkExtensions(const nlohmann::json& document, const Host& host);

/// Whether extensionsUsed or extensionsRequired lists `name`.
bool usesExtension(const nlohmann::json& document, const char* name);

}  // namespace candela_gltf
