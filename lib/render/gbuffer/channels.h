#pragma once

#include "render/layout.h"

#include <candela/frame_settings.h>
#include <candela/gbuffer.h>

#include <glm/vec3.hpp>

#include <span>

namespace candela {

/// What a channel or a debug view is computed from. The geometry pass stores the first two; the others are
/// drawn when they are asked for.
enum class ChannelSource {
    depth,
    surface,              ///< The words of the G-buffer.
    emission,             ///< Radiance as the geometry pass writes it.
    environment,          ///< `EnvironmentPass`, diffuse and specular; of AOVs only, as the next two.
    environmentDiffuse,   ///< The one part.
    environmentSpecular,  ///< The other.
    lightCount,           ///< `PairCounter`.
    shadowedCount,        ///< `Lighting::shadowedPerPixel`.
    ambientOcclusion,     ///< render/occlusion/ambient_occlusion.h; of AOVs only.
    instance,             ///< `InstancePass`; of debug views only.
    nodeId,               ///< The same, of AOVs only, as the next three.
    materialId,
    instanceId,
    motion,  ///< render/debug/motion.h.
};

/// A pixel of a frame as decoders read it. Of the members below `depth` only the one of the channel's source
/// is set.
struct ChannelPixel {
    const layout::FrameUniforms& frame;
    const glm::dvec3& origin;  ///< `Scene::origin`.
    int x, y;                  ///< y from the bottom.
    float depth;               ///< Reversed; 0 on the background.
    GBufferSurface surface;
    glm::vec3 color{0.0f};  ///< Of `emission`, the parts of the environment and `motion`.
    float number = 0.0f;    ///< Of counts, ids and `ambientOcclusion`.
};

/// A debug view of the table below.
struct DebugViewRow {
    DebugView view = DebugView::none;  ///< `none`: the channel has no debug view.
    const char* name = "";             ///< On the command line.
    ChannelSource source = ChannelSource::depth;
    /// Whether the view is scaled by the largest value in the frame, `maximum` in `code`.
    enum class Scale { fixed, maximum } scale = Scale::fixed;
    /// The display's code values: a GLSL expression of type vec3 over what shaders/debug_view.frag declares.
    const char* code = "";
};

/// A row of the channel table. It is all that a channel consists of: AOVs, debug views, the EXR file and
/// docs/gbuffer.md (compared by a test) follow it.
struct ChannelRow {
    GBufferChannel channel;
    ChannelSource source;
    /// The value at a pixel with a surface; scalars in x. Elsewhere a channel is 0.
    glm::vec3 (*decode)(const ChannelPixel& pixel);
    DebugViewRow debugView;
};

/// In the order of the EXR file.
std::span<const ChannelRow> channelRows();

/// The row of a debug view; `view` is not `none`.
const DebugViewRow& debugViewRow(DebugView view);

}  // namespace candela
