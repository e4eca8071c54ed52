#pragma once

#include "schema.h"

namespace candela_gltf {

/// The part of a glTF 2.0 document that this plugin reads, with the limits the specification sets.
const Shape& documentShape();

}  // namespace candela_gltf
