#pragma once

#include "../common/failure.h"

namespace candela_gltf {

using candela_importers::Bytes;
using candela_importers::elementName;
using candela_importers::Failure;
using candela_importers::HostRefused;
using candela_importers::readable;

}  // namespace candela_gltf
