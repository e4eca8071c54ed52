#pragma once

#include <string>

#include "failure.h"

namespace candela_obj {

/// Pushes a root node at the origin that shows the mesh, -1 for none, and returns its index.
std::int32_t pushNode(const std::string& name, std::int32_t mesh, const Host& host);

}  // namespace candela_obj
