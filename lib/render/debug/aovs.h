#pragma once

#include "render/layout.h"

#include <candela/gbuffer.h>
#include <candela/renderer.h>

#include <string>
#include <vector>

namespace candela {

/// What AOVs are made of: whole targets, rows from the bottom.
struct AovSources {
    int width, height;
    const layout::FrameUniforms& frame;
    const std::vector<GBufferTexel>& surfaces;
    const std::vector<float>& depth;
    const std::vector<float>& emission;    ///< RGBA; may be empty when not asked for.
    const std::vector<float>& lightCount;  ///< May be empty when not asked for.
};

/// Throws `Error` (badInput) naming the AOVs there are when one of `names` is none of them.
void checkAovNames(const std::vector<std::string>& names);

/// The AOV `name`, rows from the top.
Aov makeAov(const std::string& name, const AovSources& sources);

}  // namespace candela
