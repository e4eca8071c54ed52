#pragma once

#include <string>

#include "decoders.h"
#include "host.h"

namespace candela_importers {

/// Pushes a decoded picture and returns the host's index of it.
std::int32_t pushPicture(const std::string& name, const Picture& picture, const Host& host);

}  // namespace candela_importers
