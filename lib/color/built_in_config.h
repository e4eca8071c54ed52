#pragma once

#include "color/ocio.h"

namespace candela {

/// candela's own config, read from the text in the .cpp file. docs/color.md has its table.
OCIO::ConstConfigRcPtr builtInConfig();

}  // namespace candela
