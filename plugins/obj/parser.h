#pragma once

#include "document.h"

namespace candela_obj {

/// Reads an OBJ file. What it holds besides polygons becomes notes. Progress goes up to `progressEnd`.
Document parseObj(const Bytes& file, const Host& host, double progressEnd);

}  // namespace candela_obj
