#pragma once

#include "color/curve_table.h"
#include "color/display_shader.h"
#include "color/ocio.h"

#include <optional>
#include <span>
#include <vector>

namespace candela {

/// A display transform whose curves are baked: each run of per-channel steps is
/// replaced by one table. All other steps are exact.
class BakedTransform {
  public:
    /// The largest error, in 8-bit codes, with which a baked transform is used.
    static constexpr float errorLimit = 0.25f;

    /// None where fewer than two curves can be baked, or where the tables exceed the error limit.
    static std::optional<BakedTransform> make(const OCIO::ConstProcessorRcPtr& processor);

    /// Applies the transform in place on the CPU to colours of sanitised radiance: RGBA with an alpha of 1.
    /// Tables are evaluated as in the shader, exact steps by OpenColorIO.
    void apply(std::span<float> rgba) const;

    DisplayShader shader() const;

    /// The largest difference between `apply` and `exact`, in 8-bit codes, over a grid of colours.
    float maxError(const OCIO::ConstCPUProcessorRcPtr& exact) const;

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
