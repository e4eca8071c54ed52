#pragma once

#include "gltf_file.h"

namespace candela_test {

/// A JPEG file of 8 × 8 texels, all of them the grey 192.
Bytes makeGreyJpeg();

}  // namespace candela_test
