#pragma once

#include <candela/color.h>

#include "color/display_shader.h"
#include "color/ocio.h"

#include <mutex>
#include <optional>

namespace candela {

struct DisplayTransform::State {
    std::string source;  ///< The config's, for messages.
    DisplayOptions choice;
    DisplayEncoding encoding;
    OCIO::ConstProcessorRcPtr processor;
    OCIO::ConstCPUProcessorRcPtr cpu;
    mutable std::once_flag shaderOnce;
    mutable DisplayShader shader;
    mutable std::once_flag bakedOnce;
    mutable std::optional<DisplayShader> baked;
};

}  // namespace candela
