#pragma once

#include "color/curve_table.h"
#include "color/display_shader.h"
#include "color/display_steps.h"
#include "color/ocio.h"

#include <optional>
#include <span>
#include <vector>

namespace candela {

/// The steps of a transform with what they refer to.
struct OwnedDisplaySteps {
    std::vector<DisplayStep> steps;
    std::vector<std::vector<float>> tables;
    std::vector<OCIO::ConstCPUProcessorRcPtr> processors;
};

/// The step that applies the whole of a processor.
OwnedDisplaySteps exactStep(const OCIO::ConstCPUProcessorRcPtr& processor);

/// A display transform whose curves are baked: each run of per-channel steps is
/// replaced by one table. All other steps are exact.
class BakedTransform {
  public:
    /// The largest error, in 8-bit codes, with which a baked transform is used.
    static constexpr float errorLimit = 0.25f;

    /// In a shader one curve alone is faster as OpenColorIO writes it.
    static constexpr std::size_t minShaderCurves = 2;

    /// None where fewer curves than `minCurves` can be baked, or where the tables exceed the error limit.
    static std::optional<BakedTransform> make(const OCIO::ConstProcessorRcPtr& processor,
                                              std::size_t minCurves = minShaderCurves);

    /// Applies the transform in place on the CPU to colours of sanitised radiance: RGBA with an alpha of 1.
    /// Tables are evaluated as in the shader, exact steps by OpenColorIO.
    void apply(std::span<float> rgba) const;

    DisplayShader shader() const;
    OwnedDisplaySteps steps() const;

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
