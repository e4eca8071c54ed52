#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

/// The declarations that C++ and GLSL share, read from the shaders' own headers.
namespace candela::layout {

using glm::ivec4;
using glm::mat4;
using glm::vec4;

#include "shared/bindings.h"
#include "shared/frame.h"

}  // namespace candela::layout
