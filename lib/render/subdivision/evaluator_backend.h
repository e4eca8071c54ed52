#pragma once

#include "render/subdivision/compute_evaluator.h"
#include "render/subdivision/cpu_evaluator.h"

#include <candela/context.h>

#include <optional>

namespace candela {

enum class LimitForm { compute, threads };

/// "compute" or "threads".
const char* toString(LimitForm form);

/// Evaluates limit surfaces in the form that is faster on the device: compute on a GPU; on a software
/// rasteriser whichever a trial finds on the first surface that is large enough to tell, and threads until
/// then. What the compute form does not take, threads evaluate.
class EvaluatorBackend {
  public:
    explicit EvaluatorBackend(const Context& context);

    /// Decides on the form by evaluating `request` a few times, if that is still open and can be told by it.
    void choose(const LimitRequest& request);
    /// From now on this form.
    void force(LimitForm form) { form_ = form; }

    void evaluate(const LimitRequest& request);
    /// The form of the last evaluation; none before the first.
    std::optional<LimitForm> lastForm() const { return lastForm_; }

  private:
    void evaluate(const LimitRequest& request, LimitForm form);
    double trialTime(const LimitRequest& request, LimitForm form);
    ComputeEvaluator& compute();

    std::optional<LimitForm> form_, lastForm_;
    std::optional<ComputeEvaluator> compute_;  ///< Made when it is first used.
    CpuEvaluator threads_;
};

}  // namespace candela
