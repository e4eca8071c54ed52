#pragma once

#include "fields.h"

#include <candela/accumulator.h>
#include <candela/frame_settings.h>
#include <candela/sampling.h>

#include <optional>

namespace candela::python {

/// `RenderSettings` in Python: all that determines a picture of a scene from a view.
struct RenderSettings {
    FrameSettings frame;
    std::uint32_t samples = SamplingSettings{}.count;
    std::optional<float> fNumber;
    Lens lens;
    double shutter = 0.0, framesPerSecond = SamplingSettings{}.framesPerSecond;
    AovFilter aovFilter = AovFilter::automatic;

    SamplingSettings sampling() const;
};

}  // namespace candela::python
