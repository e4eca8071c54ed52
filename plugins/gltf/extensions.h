#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

#include "../common/failure.h"
#include "../common/host.h"
#include "schema.h"

namespace candela_plugins::gltf {

/// Checks the extensions of a document. What unsupported ones add to the picture is noted as missing, for the
/// elements that have them; metadata is not. Throws `Failure` when the document requires one without which
/// the picture cannot be right: neither a part of a material nor one that is left out by itself.
void checkExtensions(const nlohmann::json& document, const Host& host);

/// Whether the document declares an extension.
bool usesExtension(const nlohmann::json& document, const char* name);

/// The extension that gives a texture an image of another format than PNG and JPEG; empty for none.
std::string imageExtension(const nlohmann::json& texture);

}  // namespace candela_plugins::gltf
