#pragma once

#include "../common/failure.h"
#include "../common/host.h"

namespace candela_obj {

using candela_importers::Bytes;
using candela_importers::Failure;
using candela_importers::Host;
using candela_importers::HostRefused;
using candela_importers::readable;

}  // namespace candela_obj
