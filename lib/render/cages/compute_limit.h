#pragma once

#include "gl/program.h"
#include "render/cages/limit_streams.h"

namespace candela {

/// Evaluates limit surfaces in a compute shader.
class ComputeLimit {
  public:
    ComputeLimit();

    /// Do the buffers of the request fit the device's storage blocks, and its rows a shader's loop?
    bool takes(const LimitRequest& request) const;
    void evaluate(const LimitRequest& request) const;

  private:
    void dispatch(std::size_t first, std::size_t end, const CageTable& table) const;

    gl::Program program_;
    std::size_t greatestBlock_ = 0;  ///< Bytes.
};

}  // namespace candela
