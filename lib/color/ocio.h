#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <string>

namespace candela {

namespace OCIO = OCIO_NAMESPACE;

/// How exactly OpenColorIO works, on the CPU and on the GPU alike: only rewritings that lose nothing, so that
/// the two agree; dynamic properties (sliders of interactive tools) are frozen at the config's values.
inline constexpr auto ocioPrecision = static_cast<OCIO::OptimizationFlags>(
    OCIO::OPTIMIZATION_LOSSLESS | OCIO::OPTIMIZATION_NO_DYNAMIC_PROPERTIES);

/// OpenColorIO's reason as one line: its messages break lines, ours may not.
std::string oneLine(const std::string& message);

}  // namespace candela
