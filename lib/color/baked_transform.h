#pragma once

#include "color/curve_table.h"
#include "color/display_shader.h"
#include "color/ocio.h"

#include <optional>
#include <span>
#include <vector>

namespace candela {

/// A display transform whose curves are baked: its steps, where each run of steps that treat every channel by
/// itself is one table. All other steps stay exact.
class BakedTransform {
  public:
    /// The largest error, in 8-bit codes, with which a baked transform is used.
    static constexpr float errorLimit = 0.25f;

    /// Nothing where there is nothing to win (no more than one curve) or where tables do not meet the error
    /// limit.
    static std::optional<BakedTransform> make(const OCIO::ConstProcessorRcPtr& processor);

    /// What the baked shader makes of colours whose radiance is sanitised, on the CPU, in place: RGBA, alpha
    /// being 1. The tables work as in the shader, the exact steps are OpenColorIO's.
    void apply(std::span<float> rgba) const;

    DisplayShader shader() const;

    /// The largest difference between `apply` and `exact`, in 8-bit codes, over a grid of colours.
    float worstError(const OCIO::ConstCPUProcessorRcPtr& exact) const;

  private:
    struct Step {
        enum class Kind { exact, glowAndRed, darkToDim, curves };
        Kind kind;
        OCIO::ConstProcessorRcPtr processor;
        OCIO::ConstCPUProcessorRcPtr cpu;
        std::optional<CurveTable> table;
    };

    std::vector<Step> steps_;
};

}  // namespace candela
