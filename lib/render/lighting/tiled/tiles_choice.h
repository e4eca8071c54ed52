#pragma once

#include "render/lighting/lighting_technique.h"

#include <memory>
#include <string>

namespace candela {

/// The technique `tiles` in the form that is faster on the current context's device: compute, or vector code
/// on the CPU. Both draw the same small frame once to warm up and then against the clock; the outcome is
/// remembered for each device name (`renderer`) of this process.
std::unique_ptr<LightingTechnique> makeFasterTiles(const std::string& renderer);

}  // namespace candela
