#include "render/subdivision/evaluator_backend.h"

#include "render/subdivision/gpu_stencil_table.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace candela {

const char* toString(LimitForm form) {
    return form == LimitForm::compute ? "compute" : "threads";
}

EvaluatorBackend::EvaluatorBackend(const Context& context) {
    if (!context.isSoftware()) form_ = LimitForm::compute;
}

void EvaluatorBackend::choose(const LimitRequest& request) {
    constexpr std::size_t minVertices = 4096;
    if (form_ || request.table.refined().vertexCount() < minVertices) return;
    form_ = LimitForm::threads;
    if (!compute().takes(request)) return;
    const double byThreads = trialTime(request, LimitForm::threads);
    const double byCompute = trialTime(request, LimitForm::compute);
    if (byCompute < byThreads) {
        form_ = LimitForm::compute;
    } else {
        request.table.dropStorage();
    }
}

void EvaluatorBackend::evaluate(const LimitRequest& request) {
    choose(request);
    const bool computes =
        form_.value_or(LimitForm::threads) == LimitForm::compute && compute().takes(request);
    lastForm_ = computes ? LimitForm::compute : LimitForm::threads;
    evaluate(request, *lastForm_);
}

void EvaluatorBackend::evaluate(const LimitRequest& request, LimitForm form) {
    if (form == LimitForm::compute) {
        compute().evaluate(request);
    } else {
        threads_.evaluate(request);
    }
}

/// Seconds that an evaluation takes, the median of a few after one to warm up.
double EvaluatorBackend::trialTime(const LimitRequest& request, LimitForm form) {
    using Clock = std::chrono::steady_clock;
    evaluate(request, form);
    glFinish();
    std::array<double, 3> times{};
    for (double& time : times) {
        const Clock::time_point start = Clock::now();
        evaluate(request, form);
        glFinish();
        time = std::chrono::duration<double>(Clock::now() - start).count();
    }
    std::ranges::sort(times);
    return times[1];
}

ComputeEvaluator& EvaluatorBackend::compute() {
    if (!compute_) compute_.emplace();
    return *compute_;
}

}  // namespace candela
