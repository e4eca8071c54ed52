#pragma once

#include <cmath>

namespace candela {

using std::pow;

#define SHARED_FUNCTION inline
#include "shared/srgb.h"
#undef SHARED_FUNCTION

}  // namespace candela
