#pragma once

#include "render/layout.h"
#include "render/occlusion/occlusion_view.h"

#include <candela/frame_settings.h>
#include <candela/gbuffer.h>

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// What ambient occlusion is computed from: whole targets of `frame.size` pixels, rows from the bottom.
struct AmbientOcclusionInputs {
    const layout::FrameUniforms& frame;
    std::span<const float> depth;  ///< Reversed.
    std::span<const GBufferTexel> surfaces;
    std::span<const std::uint32_t> shadowWords;
    const OcclusionView& occluders;
    AmbientOcclusionSettings settings;
};

/// At each pixel the share of the hemisphere around the shading normal, weighted by the cosine to it, in
/// which no occluder is nearer than `settings.distance`, blended ones by 1 - alpha; 0 on the background and
/// on unlit surfaces. Runs on all threads of the library; the result depends on their number in no bit.
///
/// The directions are a Hammersley set of points, uniform in the unit disc and lifted to the hemisphere,
/// which makes their density proportional to the cosine (Malley's method: Pharr, Jakob and Humphreys,
/// "Physically Based Rendering", 13.6.3). A hash of the pixel rotates it around the normal and shifts it in
/// its strata.
std::vector<float> ambientOcclusion(const AmbientOcclusionInputs& inputs);

}  // namespace candela
