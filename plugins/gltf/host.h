#pragma once

#include "../common/host.h"
#include "failure.h"

namespace candela_gltf {

using candela_importers::Host;

}  // namespace candela_gltf
