#pragma once

#include "gl/program.h"
#include "render/subdivision/limit_streams.h"

namespace candela {

/// Evaluates limit surfaces in a compute shader.
class ComputeEvaluator {
  public:
    ComputeEvaluator();

    /// Do the buffers of the request fit the device's storage blocks, and its rows a shader's loop?
    bool takes(const LimitRequest& request) const;
    void evaluate(const LimitRequest& request) const;

  private:
    void dispatch(std::size_t first, std::size_t end, const GpuStencilTable& table) const;

    gl::Program program_;
    std::size_t maxBlock_ = 0;  ///< Bytes.
};

}  // namespace candela
