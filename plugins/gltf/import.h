#pragma once

#include <string>

#include "host.h"

namespace candela_gltf {

/// Reads the file `name` of the scene's folder and pushes it. Throws `Failure`, `HostRefused` or a standard
/// exception.
void importFile(const std::string& name, const Host& host);

}  // namespace candela_gltf
