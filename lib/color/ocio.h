#pragma once

#include "color/display_shader.h"

#include <OpenColorIO/OpenColorIO.h>

#include <string>
#include <vector>

namespace candela {

namespace OCIO = OCIO_NAMESPACE;

/// OpenColorIO's optimisation flags on the CPU and on the GPU: lossless only, so that the two agree; dynamic
/// properties (sliders of interactive tools) are frozen at the config's values.
inline constexpr auto ocioPrecision = static_cast<OCIO::OptimizationFlags>(
    OCIO::OPTIMIZATION_LOSSLESS | OCIO::OPTIMIZATION_NO_DYNAMIC_PROPERTIES);

/// OpenColorIO's reason as one line: its messages have line breaks, errors are one line.
std::string oneLine(const std::string& message);

/// candela's own config, read from the text in the .cpp file. docs/color.md has its table.
OCIO::ConstConfigRcPtr builtInConfig();

/// The GLSL that OpenColorIO writes for a transform or a part of one: a function `vec4 NAME(vec4)`; other
/// names in the text begin with `ocio` or NAME. Its look-up textures are appended to `textures`. Throws
/// `OCIO::Exception`, also where the transform has values that change from outside.
std::string exactGlsl(const OCIO::ConstProcessorRcPtr& part, const std::string& name,
                      std::vector<LookupTexture>& textures);

}  // namespace candela
