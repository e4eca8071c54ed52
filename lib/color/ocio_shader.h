#pragma once

#include "color/display_shader.h"
#include "color/ocio.h"

#include <string>
#include <vector>

namespace candela {

/// The GLSL that OpenColorIO writes for a transform or a part of one: a function `vec4 NAME(vec4)`; other
/// names in the text begin with `ocio` or NAME. Its look-up textures are appended to `textures`. Throws
/// `OCIO::Exception`, also where the transform has values that change from outside.
std::string exactGlsl(const OCIO::ConstProcessorRcPtr& part, const std::string& name,
                      std::vector<LookupTexture>& textures);

}  // namespace candela
