#pragma once

// shaders/shared/shadow_ray.h and environment_ray.h over GLM's vectors.

#include <glm/glm.hpp>

namespace candela::rays {

using namespace glm;
using Real = float;
using Real3 = vec3;
using Scalar = float;

#define SHARED_FUNCTION [[maybe_unused]] inline
#include "shared/environment_ray.h"
#include "shared/shadow_ray.h"
#undef SHARED_FUNCTION

}  // namespace candela::rays
