#pragma once

#include "render/gbuffer/channels.h"

#include <candela/frame_data.h>
#include <candela/gbuffer.h>

#include <span>
#include <string>
#include <vector>

namespace candela {

/// What AOVs are computed from: whole targets, rows from the bottom. Those that no requested channel has as
/// its source may be empty.
struct AovSources {
    int width, height;
    const layout::FrameUniforms& frame;
    glm::dvec3 origin;  ///< `Scene::origin`.
    std::span<const float> depth;
    std::span<const GBufferTexel> surfaces;
    std::span<const float> emission;                                              ///< RGBA.
    std::span<const float> environment, environmentDiffuse, environmentSpecular;  ///< RGBA.
    std::span<const float> lightCount, shadowedCount, ambientOcclusion;
    std::span<const float> nodeId, materialId, instanceId;
    std::span<const float> motion;  ///< Four floats a pixel.
};

/// The rows of these AOVs, in the order of `names`. Throws `Error` (badInput), naming the AOVs there are,
/// when a name is unknown or is given twice, and (environment) when the library has no rays for one.
std::vector<const ChannelRow*> findAovs(const std::vector<std::string>& names);

/// Whether one of the channels is computed from `source`.
bool usesSource(std::span<const ChannelRow* const> rows, ChannelSource source);

/// The AOV of a channel, rows from the top.
Aov makeAov(const ChannelRow& row, const AovSources& sources);

}  // namespace candela
